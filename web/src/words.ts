// The answer in words and large numbers.
import type { FewestAnswer, HeadingRange, Maneuver, MaxSteerRun, Snug } from "snug";
import type { Answers } from "./answers";
import { byId, set, setText } from "./dom";
import { degrees } from "./geometry";
import { drivingOf, slotOf, type Inputs } from "./inputs";

export const plural = (count: number) => (count === 1 ? "direction change" : "direction changes");
const angle = (heading: number, digits = 2) => `${degrees(heading).toFixed(digits)}°`;

const say = (verdict: string, state: "fits" | "not" | "open", count: string, unit: string, note: string) => {
    setText(byId("verdict"), verdict);
    setText(byId("count"), count);
    setText(byId("count-unit"), unit);
    setText(byId("count-note"), note);
    byId("answer").dataset.state = state;
};

/** Why not, as far as the size of the slot tells. */
function whyNot(snug: Snug, inputs: Inputs, otherwise: string) {
    const lacks = snug.shortfall(inputs.car, slotOf(inputs), drivingOf(inputs));
    const parts = [];
    if (lacks.length > 0) parts.push(`${lacks.length.toFixed(3)} m too short`);
    if (lacks.width > 0) parts.push(`${lacks.width.toFixed(3)} m too narrow`);
    return parts.length > 0 ? `The slot is ${parts.join(" and ")} to hold the car at all.` : otherwise;
}

function sayRoom({ side }: Inputs, { length, swept }: Maneuver) {
    const road = side === "left" ? -swept.y_min : swept.y_max;
    return `${length.toFixed(2)} m driven, up to ${road.toFixed(2)} m into the road.`;
}

/** `shown`: the maneuver in the picture. */
export function sayAnswer(snug: Snug, inputs: Inputs, answers: Answers, shown: Maneuver | undefined) {
    if (inputs.strategy === "fewest") sayFewest(snug, inputs, answers, shown);
    else sayEntry(snug, inputs, answers);
}

function sayEntry(snug: Snug, inputs: Inputs, { entry }: Answers) {
    setText(byId("strategy-note"), "Wheel all the way round, drive until something is touched, and back. Exact, in every frame.");
    setText(byId("maneuver-note"), "");
    const changes = entry?.direction_changes;
    const best = entry?.maneuver;
    if (changes === undefined || !best) {
        const note = whyNot(snug, inputs, "No entry heading parks it within 200 changes. All maneuvers may do better.");
        say("It does not fit", "not", "∅", "no way in", note);
        return;
    }
    const from = inputs.heading === null ? "" : "From the best heading: ";
    say("It fits", "fits", String(changes), plural(changes), from + sayRoom(inputs, best));
}

function sayFewest(snug: Snug, inputs: Inputs, { fewest, bounds }: Answers, shown: Maneuver | undefined) {
    setText(byId("strategy-note"), "Any steering, any stops: the fewest changes there can be, with proof.");
    setText(byId("maneuver-note"), !fewest && shown ? "Shown meanwhile: full steering." : "");
    if (fewest) {
        sayBounds(snug, inputs, fewest);
        return;
    }
    const low = bounds?.lower_bound ?? 0;
    const high = bounds?.direction_changes;
    const count = high === undefined ? `≥ ${low}` : low === high ? String(high) : `${low} – ${high}`;
    const spacing = bounds?.spacing ? `, lattice ${(1000 * bounds.spacing).toFixed(1)} mm` : "";
    say("Searching all maneuvers", "open", count, plural(high ?? 2), `The bounds are closing${spacing}.`);
}

function sayBounds(snug: Snug, inputs: Inputs, { direction_changes: found, proved, lower_bound, maneuver }: FewestAnswer) {
    const room = maneuver ? ` ${sayRoom(inputs, maneuver)}` : "";
    if (found !== undefined && proved) say("It fits", "fits", String(found), plural(found), `Proved: no maneuver has fewer.${room}`);
    else if (found !== undefined) say("It fits", "fits", `≤ ${found}`, plural(found), `No maneuver has fewer than ${lower_bound}.${room}`);
    else if (proved) say("It does not fit", "not", "∅", "no way in", whyNot(snug, inputs, "Proved: no maneuver with up to 200 changes parks it."));
    else say("Undecided", "open", `≥ ${lower_bound}`, plural(2), "The time given was not enough.");
}

const widest = (ranges: HeadingRange[]) =>
    ranges.reduce<HeadingRange | undefined>(
        (a, b) => (a && a.heading_max - a.heading_min >= b.heading_max - b.heading_min ? a : b),
        undefined,
    );

/** `run`: where full steering leads from the heading that was set, if one was. */
export function sayHeading(inputs: Inputs, { entry }: Answers, shown: Maneuver | undefined, run: MaxSteerRun | null, heading: number) {
    set(byId("best"), { hidden: run ? null : "" });
    if (run) {
        setText(byId("enter-at"), angle(heading));
        const moves = run.maneuver?.direction_changes ?? 0;
        const words = {
            parked: `From here full steering takes ${moves} ${plural(moves)}.`,
            "no-entry": "From here the car cannot even start.",
            stuck: `From here the car gets stuck after ${moves} ${plural(moves)}.`,
            "never-touches": "From here the car circles and never gets in.",
            "too-many-changes": "From here more than 200 changes would be needed.",
        };
        setText(byId("enter-at-note"), words[run.outcome]);
        return;
    }
    const range = widest(entry?.entry_ranges.filter((one) => one.direction_changes === entry.direction_changes) ?? []);
    if (inputs.strategy === "fewest" || !range) {
        setText(byId("enter-at"), shown ? angle(heading) : "–");
        setText(byId("enter-at-note"), shown ? "off parallel" : "");
        return;
    }
    const half = (range.heading_max - range.heading_min) / 2;
    setText(byId("enter-at"), `${angle(heading)} ± ${degrees(half).toFixed(half < 0.001 ? 3 : 2)}°`);
    setText(byId("enter-at-note"), `from ${angle(range.heading_min, 3)} to ${angle(range.heading_max, 3)} off parallel`);
}
