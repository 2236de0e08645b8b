// The answer in words and large numbers.
import type { EntryAnswer, FewestAnswer, HeadingRange, Maneuver, MaxSteerRun, Snug } from "snug";
import type { Answers } from "./answers";
import { byId, set, setText } from "./dom";
import { degrees } from "./geometry";
import { drivingOf, goalOf, plain, slotOf, type Inputs } from "./inputs";
import type { Parking } from "./parking";

export const plural = (count: number) => (count === 1 ? "direction change" : "direction changes");
const angle = (heading: number, digits = 2) => `${degrees(heading).toFixed(digits)}°`;

const say = (verdict: string, state: "fits" | "not" | "open", count: string, unit: string, note: string) => {
    setText(byId("verdict"), verdict);
    setText(byId("count"), count);
    set(byId("count"), { "data-long": count.length > 2 ? "" : null });
    setText(byId("count-unit"), unit);
    setText(byId("count-note"), note);
    byId("answer").dataset.state = state;
};

/** Why it cannot park, as far as the size of the slot tells; empty where it would hold the car. */
function tooSmall(snug: Snug, inputs: Inputs) {
    const lacks = snug.shortfall(inputs.car, slotOf(inputs), drivingOf(inputs));
    const parts = [];
    if (lacks.length > 0) parts.push(`${lacks.length.toFixed(3)} m too short`);
    if (lacks.width > 0) parts.push(`${lacks.width.toFixed(3)} m too narrow`);
    return parts.length > 0 ? `The slot is ${parts.join(" and ")} for the parallel car.` : "";
}

function sayRoom({ side }: Inputs, { length, swept }: Maneuver) {
    const road = side === "left" ? -swept.y_min : swept.y_max;
    return `${length.toFixed(2)} m driven, up to ${road.toFixed(2)} m into the road.`;
}

/** `shown`: the maneuver in the picture. */
export function sayAnswer(snug: Snug, inputs: Inputs, answers: Answers, shown: Maneuver | undefined, run: MaxSteerRun | null) {
    const short = tooSmall(snug, inputs);
    set(byId("fit-slot"), { hidden: short ? null : "" });
    const stuck = inputs.strategy !== "fewest" && !answers.late && answers.entry?.direction_changes === undefined;
    set(byId("try-all"), { hidden: stuck && !short ? null : "" });
    if (inputs.strategy === "fewest") sayFewest(snug, inputs, answers, shown);
    else sayEntry(snug, inputs, answers, run);
}

/** The solver's, as one of the page's. */
const sentence = (text: string) =>
    `${text.charAt(0).toUpperCase()}${text.slice(1).replace(/\d+\.\d{4,}/g, (digits) => plain(Number(digits), 3))}.`.replace(/\.\.$/, ".");

/** Never broken before the unit. */
const metres = (value: number) => `${value.toFixed(2)}\u00a0m`;

/** In the street: the exact answer where there is one, else what the map says. `map`: null while there is none of this place. */
export function sayPark(snug: Snug, inputs: Inputs, { bounds, stale, exact, proved: before, soFar, pose, trouble }: Parking, map: { spacing: number } | null) {
    for (const id of ["try-all", "best"]) set(byId(id), { hidden: "" });
    const short = inputs.scene ? "" : tooSmall(snug, inputs);
    set(byId("fit-slot"), { hidden: short ? null : "" });
    const out = goalOf(inputs) === "road";
    const [fits, fitsNot] = out ? ["It gets out", "It does not get out"] : ["It parks", "It does not park"];
    setText(byId("strategy-note"), "Any steering, any stops: the fewest changes there can be, with proof.");
    setText(byId("maneuver-note"), exact?.maneuver || !(before?.maneuver ?? bounds?.first) ? "" : "Checked by exact contact; a roomier one may follow.");
    setText(byId("stands"), `${metres(pose.x)}, ${metres(pose.y)}`.replaceAll("-", "−"));
    const turned = `${Number(degrees(pose.heading).toFixed(2)) + 0}°`.replace("-", "−");
    setText(byId("stands-note"), `${inputs.scene ? `Turned ${turned}.` : `${turned} to the street.`} ${inputs.pose ? "" : "Drag the car anywhere."}`);
    set(byId("usual"), { hidden: inputs.pose ? null : "" });

    const ago = "Of a moment ago; the street is being swept.";
    const range = (low: number, high?: number) => (high === undefined ? `≥ ${low}` : low === high ? String(high) : `${low} – ${high}`);
    if (stale || (!map && !bounds)) setText(byId("map-says"), "…");
    else if (!bounds) setText(byId("map-says"), "–");
    else if (bounds.where === "outside") setText(byId("map-says"), "beyond it");
    else setText(byId("map-says"), bounds.where === "blocked" ? "blocked" : bounds.impossible ? "impossible" : range(bounds.lower_bound, bounds.direction_changes));
    setText(byId("map-note"), map ? `From every pose at once, on a lattice of ${plain(100 * map.spacing, 1)} cm.` : "The street is swept …");

    const answer = exact ?? before;
    if (answer) {
        const { direction_changes: found, lower_bound, proved, impossible, maneuver, spacing } = answer;
        const room = exact && maneuver ? ` ${metres(maneuver.length)} driven.` : "";
        if (found === 0 && maneuver?.moves.length === 0) say(out ? "It is out" : "It is parked", "fits", "0", plural(0), "Nothing to drive.");
        else if (found !== undefined && proved) say(fits!, "fits", String(found), plural(found), `Proved: no maneuver has fewer.${room}`);
        else if (found !== undefined) say(fits!, "fits", `≤ ${found}`, plural(found), `No maneuver has fewer than ${lower_bound}.${room}`);
        else if (proved) say(fitsNot!, "not", "∅", "no way", impossible ? short || "Proved: no number of changes will do." : `Proved: not with up to ${answer.max_changes} changes.`);
        else say("Undecided", "open", `≥ ${lower_bound}`, plural(2), `Nothing found on a lattice of ${plain(1000 * spacing, 1)} mm in the time given.`);
        return;
    }
    // What the search found is of this place, what the map of a moment ago says may not be.
    const search = soFar && (soFar.lower_bound > 0 || soFar.direction_changes !== undefined) ? soFar : null;
    const mapped = stale && search ? null : bounds;
    if (mapped?.where === "blocked") say("It cannot stand here", "not", "–", "it meets something", "Move the car, or turn it, until it stands free.");
    else if (trouble) say("No answer", "open", "–", "", sentence(trouble));
    else if (mapped?.where === "outside") say("Beyond the map", "open", "…", "", "It covers headings within 80° of the middle between the street’s and the parked one. Searching from here alone.");
    else if (mapped?.impossible) say(fitsNot!, "not", "∅", "no way", short || (stale ? ago : "Proved by the map: no number of changes will do."));
    else if (!mapped && !search) say("Computing", "open", "…", "direction changes", "The street is being swept.");
    else {
        const low = Math.max(mapped?.lower_bound ?? 0, search?.lower_bound ?? 0);
        const high = Math.min(mapped?.direction_changes ?? Infinity, search?.direction_changes ?? Infinity);
        const known = high < Infinity ? high : undefined;
        const word = known === undefined ? "Searching" : fits!;
        const note =
            mapped && stale
                ? ago
                : low === known
                  ? "Proved: no maneuver has fewer."
                  : known === undefined
                    ? "No way is known yet. The search from here goes on."
                    : known === mapped?.direction_changes
                      ? "From the map, checked by exact contact; the proof follows."
                      : "Found from here. The search for fewer goes on, then the way is shown.";
        say(word, known === undefined ? "open" : "fits", range(low, known), plural(known ?? 2), note);
    }
}

function sayEntry(snug: Snug, inputs: Inputs, { entry }: Answers, run: MaxSteerRun | null) {
    setText(byId("strategy-note"), "Wheel all the way round, drive until something is touched, and back. Exact, in every frame.");
    setText(byId("maneuver-note"), "");
    const changes = entry?.direction_changes;
    const best = entry?.maneuver;
    if (changes === undefined || !best) {
        const none = "o entry heading parks it within 200 changes";
        const note = tooSmall(snug, inputs) || (entry?.proved ? `Proved: n${none}.` : `N${none}. ${unsure(entry)}`);
        say("It does not fit", "not", "∅", "no way in", note);
        return;
    }
    if (run && run.outcome !== "parked") {
        say("Not from this heading", "not", "∅", "no way in", `The best heading takes ${changes} ${plural(changes)}.`);
        return;
    }
    const mine = run?.maneuver ?? best;
    const here = mine.direction_changes;
    const better = run && here > changes ? `The best heading takes ${changes}. ` : "";
    say("It fits", "fits", String(here), plural(here), `${better}${entry?.proved ? "Proved: no heading takes fewer." : unsure(entry)} ${sayRoom(inputs, mine)}`);
}

/** Of full steering. */
const unsure = (entry: EntryAnswer | null) => (entry?.undecided ? "Some headings are too close to call." : "Not proved yet.");

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
    else if (proved) say("It does not fit", "not", "∅", "no way in", tooSmall(snug, inputs) || "Proved: no maneuver with up to 200 changes parks it.");
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
