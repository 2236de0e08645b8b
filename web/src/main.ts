// The page: what was set goes to the solver each frame, and its answer into words, numbers and the picture.
import type { EntryAnswer, FewestAnswer, FewestProgress, HeadingRange, Maneuver, Snug } from "snug";
import { legend } from "./colors";
import { byId, html, set, setText } from "./dom";
import { asPng, rangesCsv, save, standalone } from "./download";
import { createDrawing, type Scene } from "./drawing";
import { degrees, entryPose, track } from "./geometry";
import {
    carNumberFields, commandLine, fieldValue, fromLink, limits, parseNumber, plain, toLink, withField,
    type Inputs, type NumberField,
} from "./inputs";
import { createMap, grid } from "./map";
import { createPlayer } from "./player";
import { asker } from "./questions";
import { compile, start } from "./solver";

const carTitles: Record<string, string> = {
    "mid-size": "Mid-sized car",
    "renault-zoe": "Renault ZOE",
    "opel-corsa": "Opel Corsa",
    "vw-transporter": "VW Transporter",
    "mercedes-amg-gt": "Mercedes-AMG GT",
};
const fieldTitles: Record<NumberField, string> = {
    length: "Length [m]",
    width: "Width [m]",
    clearance: "Clearance [m]",
    heading: "Heading [°]",
    "car-width": "Width [m]",
    "car-front": "Front [m]",
    "car-rear": "Rear [m]",
    "car-wheelbase": "Wheelbase [m]",
    "car-steer": "Steering [°]",
};

const plural = (count: number) => (count === 1 ? "direction change" : "direction changes");
const angle = (heading: number, digits = 2) => `${degrees(heading).toFixed(digits)}°`;
const later = (milliseconds: number) => {
    let timer = 0;
    return (what: () => void) => {
        clearTimeout(timer);
        timer = window.setTimeout(what, milliseconds);
    };
};

function run(snug: Snug, module: WebAssembly.Module) {
    const catalogue = snug.cars();
    const questions = asker(module);
    /** What a link leaves out. */
    const usual: Inputs = {
        car: catalogue.find((car) => car.name === "renault-zoe")!,
        length: 4.9,
        width: 2.0,
        side: "right",
        clearance: 0,
        enter: "backward",
        strategy: "max-steer",
        heading: null,
    };
    const link = fromLink(location.hash.slice(1), usual, catalogue);
    let inputs = link.inputs;
    let entry: EntryAnswer | null = null;
    let fewest: FewestAnswer | null = null;
    let bounds: FewestProgress | null = null;
    let allRanges: HeadingRange[] = [];
    let shown: Maneuver | undefined;
    let swept = true;
    const frameTimes: number[] = [];

    // --- setting things
    let due = false;
    const refresh = () => {
        if (due) return;
        due = true;
        requestAnimationFrame(frame);
    };
    const change = (next: Inputs) => {
        const sameQuestion =
            next.car === inputs.car && next.length === inputs.length && next.width === inputs.width &&
            next.side === inputs.side && next.clearance === inputs.clearance && next.enter === inputs.enter &&
            next.strategy === inputs.strategy;
        inputs = sameQuestion || next.heading !== inputs.heading ? next : { ...next, heading: null };
        refresh();
    };
    const within = (field: NumberField, value: number) => Math.min(Math.max(value, limits[field].low), limits[field].high);

    const drawing = createDrawing(byId<SVGSVGElement>("drawing"), {
        length: (value) => change({ ...inputs, length: within("length", value) }),
        width: (value) => change({ ...inputs, width: within("width", value) }),
        heading: (value) => change({ ...inputs, heading: value }),
        released: () => {
            if (inputs.strategy === "max-steer") soonRanges(askRanges);
            refresh();
        },
    });
    const player = createPlayer((pose, steer) => drawing.showCar(pose, steer));
    const moveSlot = (extraLength: number, extraWidth: number) =>
        change({
            ...inputs,
            length: within("length", inputs.car.front + inputs.car.rear + extraLength),
            width: within("width", inputs.car.width + extraWidth),
        });
    const maps = {
        "max-steer": createMap("map-max-steer", "Direction changes with full steering, by size of the slot", moveSlot),
        fewest: createMap("map-fewest", "Direction changes over all maneuvers, by size of the slot", moveSlot),
    };

    const fields = new Map<NumberField, { input: HTMLInputElement; error: HTMLElement }>();
    const addField = (field: NumberField, parent: string) => {
        const error = html("span", { class: "error", id: `${field}-error`, role: "alert" });
        const input = html("input", {
            id: field,
            name: field,
            type: "text",
            inputmode: "decimal",
            maxlength: 40,
            spellcheck: "false",
            "aria-describedby": error.id,
        });
        byId(parent).append(html("div", { class: "number" }, html("label", { for: field }, fieldTitles[field]), input, error));
        input.addEventListener("input", () => {
            if (field === "heading" && input.value.trim() === "") {
                complain(field, "");
                change({ ...inputs, heading: null });
                return;
            }
            const value = parseNumber(field, input.value);
            complain(field, typeof value === "string" ? value : "");
            filled.set(field, typeof value === "number" ? value : fieldValue(inputs, field));
            if (typeof value === "number") change(withField(inputs, field, value));
        });
        input.addEventListener("blur", () => {
            if (input.getAttribute("aria-invalid") !== "true") fill(field);
        });
        input.addEventListener("keydown", (event) => {
            const step = { ArrowUp: 1, ArrowDown: -1 }[event.key];
            const value = fieldValue(inputs, field);
            if (!step || value === null) return;
            event.preventDefault();
            const by = (field === "heading" || field === "car-steer" ? 0.1 : 0.01) * (event.shiftKey ? 10 : 1);
            complain(field, "");
            const next = within(field, Number((value + step * by).toFixed(6)));
            input.value = plain(next);
            change(withField(inputs, field, next));
        });
        fields.set(field, { input, error });
    };
    const complain = (field: NumberField, sentence: string) => {
        const { input, error } = fields.get(field)!;
        setText(error, sentence);
        set(input, { "aria-invalid": sentence ? "true" : null });
    };
    /** The value into its field, unless something is being typed there, or was and is still explained. */
    const filled = new Map<NumberField, number | null>();
    const fill = (field: NumberField) => {
        const { input } = fields.get(field)!;
        const value = fieldValue(inputs, field);
        if (document.activeElement === input || (input.getAttribute("aria-invalid") && filled.get(field) === value)) return;
        filled.set(field, value);
        input.value = value === null ? "" : plain(value, field === "heading" ? 3 : 4);
        complain(field, "");
    };
    for (const field of carNumberFields) addField(field, "car-fields");
    for (const field of ["length", "width"] as const) addField(field, "slot-fields");
    for (const field of ["clearance", "heading"] as const) addField(field, "driving-fields");
    set(fields.get("heading")!.input, { placeholder: "best" });

    const carChoice = byId<HTMLSelectElement>("car");
    carChoice.append(
        ...catalogue.map((car) => html("option", { value: car.name }, carTitles[car.name!] ?? car.name!)),
        html("option", { value: "" }, "My own dimensions"),
    );
    carChoice.addEventListener("change", () => {
        const car = catalogue.find((one) => one.name === carChoice.value);
        if (car) change({ ...inputs, car });
        else {
            const { name: _, ...own } = inputs.car;
            change({ ...inputs, car: own });
            document.querySelector("details")!.open = true;
        }
    });
    byId("inputs").addEventListener("submit", (event) => event.preventDefault());
    byId("inputs").addEventListener("change", (event) => {
        const { name, value, type } = event.target as HTMLInputElement;
        if (type === "radio") change({ ...inputs, [name]: value });
    });
    byId("swept").addEventListener("change", (event) => {
        swept = (event.target as HTMLInputElement).checked;
        refresh();
    });
    byId("best").addEventListener("click", () => change({ ...inputs, heading: null }));
    byId("legend").append(
        ...legend.map(({ color, label }) => {
            const swatch = html("span", { class: "swatch", "aria-hidden": "true" });
            swatch.style.background = color;
            return html("li", {}, swatch, label);
        }),
        html("li", {}, html("span", { class: "swatch none", "aria-hidden": "true" }), "none"),
    );

    // --- answers
    const slot = () => ({ length: inputs.length, width: inputs.width, side: inputs.side });
    const options = () => ({ clearance: inputs.clearance, enter: inputs.enter });
    let asked = "";
    let mapped = "";
    const soonFewest = later(120);
    const soonShorter = later(60);
    const soonRanges = later(80);
    const soonMap = later(350);
    const soonLink = later(300);

    function frame() {
        due = false;
        const question = JSON.stringify([inputs.car, slot(), options(), inputs.strategy]);
        const changed = question !== asked;
        asked = question;
        try {
            if (changed) {
                const before = performance.now();
                entry = snug.entry(inputs.car, slot(), options());
                frameTimes.push(performance.now() - before);
                if (frameTimes.length > 600) frameTimes.shift();
                allRanges = entry.entry_ranges;
                fewest = null;
                bounds = null;
                questions.abandon("fewest");
                questions.abandon("min-slot");
                if (inputs.strategy === "fewest") soonFewest(askFewest);
                else {
                    soonFewest(() => {});
                    soonShorter(askShorter);
                    soonRanges(askRanges);
                }
                setText(byId("shorter"), "…");
                setText(byId("shorter-note"), "");
            }
            const run = inputs.heading === null ? null : snug.maxSteer(inputs.car, slot(), inputs.heading, options());
            trouble("");
            present(run);
        } catch (error) {
            trouble(error instanceof Error ? error.message : String(error));
            return;
        }
        for (const field of fields.keys()) fill(field);
        carChoice.value = inputs.car.name ?? "";
        for (const name of ["side", "enter", "strategy"] as const)
            for (const radio of document.querySelectorAll<HTMLInputElement>(`input[name=${name}]`))
                radio.checked = radio.value === inputs[name];
        const extra = [inputs.length - inputs.car.front - inputs.car.rear, inputs.width - inputs.car.width] as const;
        for (const map of Object.values(maps)) map.show(...extra);
        const mapQuestion = JSON.stringify([inputs.car, options()]);
        if (mapQuestion !== mapped) {
            mapped = mapQuestion;
            for (const kind of ["max-steer", "fewest"] as const) {
                questions.abandon(`map-${kind}`);
                maps[kind].clear();
            }
            mapsDue = true;
            askMaps();
        }
        setText(byId("command"), commandLine(inputs));
        soonLink(() => {
            const mine = `#${toLink(inputs)}`;
            if (location.hash !== mine) history.replaceState(null, "", mine);
        });
    }

    // The maps are computed once they are looked at.
    let mapsDue = false;
    let mapsSeen = false;
    const askMaps = () =>
        soonMap(() => {
            if (!mapsDue || !mapsSeen) return;
            mapsDue = false;
            askMap("max-steer");
        });
    new IntersectionObserver((entries) => {
        mapsSeen = entries.some((one) => one.isIntersecting);
        askMaps();
    }).observe(byId("map-max-steer"));

    function askFewest() {
        questions.ask("fewest", "fewest", { car: inputs.car, ...slot(), ...options() }, (told) => {
            if ("error" in told) trouble(told.error);
            else if ("so_far" in told) bounds = told.so_far;
            else {
                fewest = told.answer;
                askShorter();
            }
            refresh();
        });
    }

    function askShorter() {
        const count = inputs.strategy === "fewest" ? fewest?.direction_changes : entry?.direction_changes;
        const most = count === undefined ? (inputs.strategy === "fewest" ? 12 : 200) : count - 1;
        const title = count === undefined ? "Shortest slot of this width" : "One change fewer";
        setText(byId("shorter-title"), title);
        if (most < 0) {
            setText(byId("shorter"), "none needed");
            setText(byId("shorter-note"), "It cannot be fewer than no change at all.");
            return;
        }
        const { width, length, car, strategy } = inputs;
        questions.ask("min-slot", "min-slot", { car, width, ...options(), max_changes: most, strategy }, (told) => {
            if ("error" in told) {
                setText(byId("shorter"), "–");
                setText(byId("shorter-note"), told.error);
                return;
            }
            const enough = told.row.length;
            if (enough === null) {
                setText(byId("shorter"), "no length will do");
                setText(byId("shorter-note"), `No slot ${width.toFixed(3)} m wide is long enough; it would have to be wider.`);
                return;
            }
            const more = Math.ceil((enough - length) * 1000 - 1e-6) / 1000;
            setText(byId("shorter"), more > 0 ? `+ ${more < 0.1 ? `${Math.round(more * 1000)} mm` : `${more.toFixed(3)} m`}` : "this one");
            const with_ = count === undefined ? "" : ` for ${most} ${plural(most)}`;
            setText(byId("shorter-note"), `${(length + Math.max(more, 0)).toFixed(3)} m long${with_}.`);
        });
    }

    /** More of the fan than the best ranges: what the other headings take. */
    function askRanges() {
        if (entry?.direction_changes === undefined || drawing.busy()) return;
        allRanges = snug.entry(inputs.car, slot(), { ...options(), max_changes: entry.direction_changes + 6 }).entry_ranges;
        refresh();
    }

    function askMap(strategy: "max-steer" | "fewest") {
        questions.ask(`map-${strategy}`, "map", { car: inputs.car, ...options(), grid, strategy }, (told) => {
            if ("error" in told) maps[strategy].state(told.error);
            else {
                maps[strategy].fill(told.cells, told.done);
                if (told.done && strategy === "max-steer") askMap("fewest");
            }
        });
    }

    let loaded: Maneuver | undefined | null = null;
    function present(run: ReturnType<Snug["maxSteer"]> | null) {
        const all = inputs.strategy === "fewest";
        const best = all ? (fewest?.maneuver ?? entry?.maneuver) : entry?.maneuver;
        shown = run ? run.maneuver : best;
        const heading = inputs.heading ?? bestHeading(shown);
        const scene: Scene = {
            car: inputs.car,
            length: inputs.length,
            width: inputs.width,
            left: inputs.side === "left",
            forward: inputs.enter === "forward",
            clearance: inputs.clearance,
            heading,
            ranges: allRanges,
            track: shown ? track(shown, inputs.side) : null,
            parked: run ? run.outcome === "parked" : true,
            swept,
        };
        drawing.render(scene);
        if (loaded !== shown || !shown) {
            loaded = shown;
            player.load(shown && scene.track ? { car: inputs.car, maneuver: shown, track: scene.track } : null);
        } else player.place();
        if (!shown) drawing.showCar(entryPose(inputs.car, inputs.length, heading, scene.forward, inputs.clearance), 0);
        if (all) presentFewest();
        else presentEntry();
        presentHeading(run, heading);
    }

    function bestHeading(maneuver: Maneuver | undefined) {
        const turned = maneuver ? maneuver.entry.heading : 0;
        return Math.min(Math.max((inputs.side === "left" ? -1 : 1) * (inputs.enter === "forward" ? -1 : 1) * turned, 0), Math.PI / 2);
    }

    const say = (verdict: string, state: "fits" | "not" | "open", count: string, unit: string, note: string) => {
        setText(byId("verdict"), verdict);
        setText(byId("count"), count);
        setText(byId("count-unit"), unit);
        setText(byId("count-note"), note);
        byId("answer").dataset.state = state;
    };

    /** Why not, as far as the size of the slot tells. */
    function whyNot(otherwise: string) {
        const lacks = snug.shortfall(inputs.car, slot(), { clearance: inputs.clearance });
        const parts = [];
        if (lacks.length > 0) parts.push(`${lacks.length.toFixed(3)} m too short`);
        if (lacks.width > 0) parts.push(`${lacks.width.toFixed(3)} m too narrow`);
        return parts.length > 0 ? `The slot is ${parts.join(" and ")} to hold the car at all.` : otherwise;
    }

    function presentEntry() {
        setText(byId("strategy-note"), "Wheel all the way round, drive until something is touched, and back. Exact, in every frame.");
        setText(byId("maneuver-note"), "");
        const changes = entry?.direction_changes;
        if (changes === undefined)
            say("It does not fit", "not", "∅", "no way in", whyNot("No entry heading parks it within 200 changes. All maneuvers may do better."));
        else
            say("It fits", "fits", String(changes), plural(changes), `${shown && inputs.heading === null ? `${shown.length.toFixed(2)} m driven, ` : ""}out in the road ${roadside()} m`);
    }

    const roadside = () => {
        const maneuver = entry?.maneuver;
        if (!maneuver) return "0";
        return (inputs.side === "left" ? -maneuver.swept.y_min : maneuver.swept.y_max).toFixed(2);
    };

    function presentFewest() {
        setText(byId("strategy-note"), "Any steering, any stops: the fewest changes there can be, with proof.");
        const meanwhile = !fewest && shown ? "Shown meanwhile: full steering." : "";
        setText(byId("maneuver-note"), meanwhile);
        if (fewest) {
            const { direction_changes: found, proved, lower_bound } = fewest;
            if (found !== undefined && proved) say("It fits", "fits", String(found), plural(found), "Proved: no maneuver has fewer.");
            else if (found !== undefined) say("It fits", "fits", `≤ ${found}`, plural(found), `No maneuver has fewer than ${lower_bound}.`);
            else if (proved) say("It does not fit", "not", "∅", "no way in", whyNot("Proved: no maneuver with up to 200 changes parks it."));
            else say("Undecided", "open", `≥ ${lower_bound}`, plural(2), "The time given was not enough.");
            return;
        }
        const low = bounds?.lower_bound ?? 0;
        const high = bounds?.direction_changes;
        const spacing = bounds?.spacing ? `, lattice ${(1000 * bounds.spacing).toFixed(1)} mm` : "";
        say("Searching all maneuvers", "open", high === undefined ? `≥ ${low}` : low === high ? String(high) : `${low} – ${high}`, plural(high ?? 2), `The bounds are closing${spacing}.`);
    }

    function presentHeading(run: ReturnType<Snug["maxSteer"]> | null, heading: number) {
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
        const range = widest(entry?.entry_ranges.filter((one) => one.direction_changes === entry?.direction_changes) ?? []);
        if (inputs.strategy === "fewest" || !range) {
            setText(byId("enter-at"), shown ? angle(heading) : "–");
            setText(byId("enter-at-note"), shown ? "off parallel" : "");
            return;
        }
        const half = (range.heading_max - range.heading_min) / 2;
        setText(byId("enter-at"), `${angle(heading)} ± ${degrees(half).toFixed(half < 0.001 ? 3 : 2)}°`);
        setText(byId("enter-at-note"), `from ${angle(range.heading_min, 3)} to ${angle(range.heading_max, 3)} off parallel`);
    }

    const widest = (ranges: HeadingRange[]) =>
        ranges.reduce<HeadingRange | undefined>(
            (a, b) => (a && a.heading_max - a.heading_min >= b.heading_max - b.heading_min ? a : b),
            undefined,
        );

    // --- taking it away
    const answerNow = () => (inputs.strategy === "fewest" ? fewest : entry);
    const base = () => `snug-${inputs.car.name ?? "own"}-${plain(inputs.length)}x${plain(inputs.width)}`;
    const told = (sentence: string) => setText(byId("shared"), sentence);
    const copy = async (text: string, what: string) => {
        try {
            await navigator.clipboard.writeText(text);
            told(`${what} copied.`);
        } catch {
            told(`Copy this: ${text}`);
        }
    };
    byId("copy-link").addEventListener("click", () => void copy(`${location.href.split("#")[0]}#${toLink(inputs)}`, "Link"));
    byId("copy-command").addEventListener("click", () => void copy(commandLine(inputs), "Command"));
    const picture = byId<SVGSVGElement>("drawing");
    byId("save-svg").addEventListener("click", () => save(`${base()}.svg`, new Blob([standalone(picture)], { type: "image/svg+xml" })));
    byId("save-png").addEventListener("click", () => {
        asPng(picture).then((png) => save(`${base()}.png`, png), (error: unknown) => told(String(error)));
    });
    byId("save-json").addEventListener("click", () => {
        const answer = answerNow();
        if (!answer) told("The answer is still being searched for.");
        else save(`${base()}.json`, new Blob([JSON.stringify(answer, null, 2) + "\n"], { type: "application/json" }));
    });
    byId("save-csv").addEventListener("click", () => {
        const answer = answerNow();
        if (!answer) told("The answer is still being searched for.");
        else save(`${base()}.csv`, new Blob([rangesCsv(answer.entry_ranges)], { type: "text/csv" }));
    });

    // --- what is wrong with a link is said next to the field it means, else at the top
    let complaints: string[] = [];
    function trouble(sentence: string) {
        const all = [...complaints, sentence].filter(Boolean).join(" ");
        setText(byId("trouble"), all);
        set(byId("trouble"), { hidden: all ? null : "" });
    }
    byId("inputs").addEventListener("input", () => (complaints = []));
    const follow = (read: typeof link) => {
        inputs = read.inputs;
        complaints = read.complaints.filter(({ field }) => !field).map(({ sentence }) => sentence);
        frame();
        for (const { field, sentence } of read.complaints) {
            if (!field) continue;
            complain(field, sentence);
            if (field.startsWith("car-")) document.querySelector("details")!.open = true;
        }
    };
    window.addEventListener("hashchange", () => follow(fromLink(location.hash.slice(1), usual, catalogue)));

    follow(link);
    document.documentElement.dataset.ready = String(Math.round(performance.now()));
    // For the tests of the page.
    Object.assign(window, { snugPage: { snug, frameTimes, inputs: () => inputs, answer: answerNow } });
}

async function begin() {
    if (typeof WebAssembly !== "object") throw new Error("This page needs a browser with WebAssembly; any from 2022 on has it.");
    let module: WebAssembly.Module;
    let snug: Snug;
    try {
        module = await compile();
        snug = await start(module);
    } catch (error) {
        throw new Error(`The solver could not be started here: ${error instanceof Error ? error.message : String(error)}. Any browser from 2022 on runs it.`);
    }
    run(snug, module);
}

begin().catch((error: unknown) => {
    const trouble = byId("trouble");
    setText(trouble, error instanceof Error ? error.message : String(error));
    trouble.hidden = false;
});

