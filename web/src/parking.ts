// The answers in the street: from the map in the same frame, or a moment later from a worker's finer one, and from the exact
// search once the car stands still.
import type { FewestProgress, MapBounds, Maneuver, ParkAnswer, Pose, Scene, Snug } from "snug";
import { drivingOf, goalOf, placeOf, type Inputs } from "./inputs";
import { later } from "./later";
import type { Asker, Slice } from "./questions";
import { createStreetMap, type Seen } from "./street_map";

interface Listener {
    changed(): void;
    /** The same, and somebody waits for it. */
    answered(): void;
    /** Something is being dragged: the exact search waits. */
    busy(): boolean;
    /** What of the street is in the picture, and how finely it is painted there. */
    slice(heading: number): Slice | null;
}

export interface Parking {
    /** The place with everything that is drawn; its start is the usual one. */
    scene: Scene;
    pose: Pose;
    /** The map's. */
    bounds: MapBounds | null;
    way: Maneuver | null;
    /** Where the car stood when they were looked up. */
    lookedAt: Pose | null;
    /** They are of the place of a moment ago. */
    stale: boolean;
    /** Of the last slice that came. */
    painted: { slice: Slice; counts: NonNullable<Seen["counts"]> } | null;
    exact: ParkAnswer | null;
    /** Proved a moment before that; the way is any with so few changes. */
    proved: ParkAnswer | null;
    soFar: FewestProgress | null;
    trouble: string;
}

type Counted = Pick<Maneuver, "moves" | "direction_changes">;
const changes = (way: Counted | null) => way?.direction_changes ?? Infinity;

/** A search that begins anew takes back nothing. */
const closer = (now: FewestProgress, before: FewestProgress | null): FewestProgress => {
    const known = [now, before].flatMap((one) => one?.direction_changes ?? []);
    return {
        ...now,
        lower_bound: Math.max(now.lower_bound, before?.lower_bound ?? 0),
        ...(known.length > 0 ? { direction_changes: Math.min(...known) } : {}),
    };
};

export function createParking(snug: Snug, questions: Asker, listener: Listener) {
    const state: Parking = {
        scene: { obstacles: [], parked: { inside: [], heading: 0 }, start: [0, 0, 0] },
        pose: { x: 0, y: 0, heading: 0 },
        bounds: null,
        way: null,
        lookedAt: null,
        stale: false,
        painted: null,
        exact: null,
        proved: null,
        soFar: null,
        trouble: "",
    };
    let place = "";
    let asked = "";
    let searching = false; // for the exact answer to that
    let wanted: Inputs | null = null;
    /** The slice that came last. */
    let painted = "";
    const soonExact = later(40);
    /** How long after the last change, and after the end of a drag, there was an answer, a way and a proved one; for the bench. [ms] */
    const times = { answers: [] as number[], ways: [] as number[], proofs: [] as number[] };
    let [since, sinceStill, wayless] = [NaN, NaN, NaN]; // not a number: told already
    const tellTimes = () => {
        const now = performance.now();
        const mapped = state.lookedAt === state.pose && !state.stale;
        if (since && (state.exact ?? state.proved ?? mapped)) {
            times.answers.push(now - since);
            since = NaN;
        }
        if (wayless && !listener.busy() && (state.exact ?? state.proved ?? (mapped && state.way))) {
            times.ways.push(now - wayless);
            wayless = NaN;
        }
        if (sinceStill && !listener.busy() && (state.exact ?? state.proved ?? (mapped && state.way && state.bounds?.proved))) {
            times.proofs.push(now - sinceStill);
            sinceStill = NaN;
        }
    };

    const map = createStreetMap(snug, questions, {
        busy: listener.busy,
        first: (pose, seen) => {
            if (pose !== state.pose) return;
            Object.assign(state, { ...seen, lookedAt: pose, stale: false, trouble: "" });
            tellTimes();
            if (listener.busy()) listener.changed();
            else listener.answered();
            soonExact(askExact, 0);
        },
        ready: () => {
            painted = "";
            lookUp();
            look();
            listener.changed();
        },
        seen: ({ pose, slice }, { bounds, way, counts }) => {
            if (!map.state()?.near) return; // of a place that was left
            state.trouble = "";
            // While the car is dragged, one map says all: no count jumps to and fro. Nor is what is known taken back.
            const stale = !map.state()?.current;
            const stays = (listener.busy() && map.state()?.own) || (stale && state.lookedAt === pose && !state.stale);
            if (pose === state.pose && !stays) Object.assign(state, { bounds, way, lookedAt: pose, stale });
            if (slice && counts) {
                state.painted = { slice, counts };
                painted = JSON.stringify(slice);
            }
            tellTimes();
            listener.changed();
        },
        failed: (sentence) => {
            state.trouble = sentence;
            Object.assign(state, { bounds: null, way: null, painted: null });
            listener.changed();
        },
    });

    const look = () => {
        const slice = listener.slice(state.pose.heading);
        map.look({ pose: state.pose, slice: JSON.stringify(slice) === painted ? null : slice });
    };

    /** In the page's own map, if that is of this place. */
    const lookUp = () => {
        const seen = map.at(state.pose);
        if (seen) Object.assign(state, { ...seen, lookedAt: state.pose, stale: false });
        tellTimes();
    };

    /** Nothing is dragged any more. */
    const released = () => {
        const now = performance.now();
        if (since) since = now;
        if (sinceStill) sinceStill = now;
        if (wayless) wayless = now;
        map.hurry();
        map.takeOver();
        tellTimes();
        look();
        // Two at a time would wait for each other where there are few cores.
        soonExact(askExact, state.lookedAt === state.pose && !state.stale ? 0 : 60);
    };

    const caseOf = (inputs: Inputs) => ({
        car: inputs.car,
        place: placeOf(inputs),
        options: { ...drivingOf(inputs), goal: goalOf(inputs) } as const,
    });

    const askExact = () => {
        if (!wanted) return;
        if (listener.busy()) {
            soonExact(askExact);
            return;
        }
        if (searching) return;
        searching = true;
        const mine = asked;
        questions.ask("park", "park", { ...caseOf(wanted), start: state.pose }, (told) => {
            if (mine !== asked) return;
            if ("error" in told) state.trouble = told.error;
            else if ("so_far" in told) state.soFar = closer(told.so_far, state.soFar);
            else if ("proved" in told) state.proved = told.proved;
            else state.exact = told.answer;
            tellTimes();
            listener.changed();
        });
    };

    /** Where the car stands unless it is put somewhere: the usual start, or in the middle of the slot when it is to leave. */
    const usualPose = (inputs: Inputs, scene: Scene): Pose => {
        const [x, y, heading] = scene.start;
        if (goalOf(inputs) === "bay" || !("inside" in scene.parked)) return { x, y, heading };
        const corners = scene.parked.inside;
        const middle = { x: 0, y: 0, heading: scene.parked.heading };
        for (const [cx, cy] of corners) {
            middle.x += cx / corners.length;
            middle.y += cy / corners.length;
        }
        const back = (inputs.car.front - inputs.car.rear) / 2;
        const round = (value: number) => Number(value.toFixed(3)) + 0;
        return { x: round(middle.x - back * Math.cos(middle.heading)), y: round(middle.y - back * Math.sin(middle.heading)), heading: middle.heading };
    };

    /** True where the question is a new one. Throws the solver's sentence, and keeps the last place, where it has none. */
    const ask = (inputs: Inputs): boolean => {
        const its = caseOf(inputs);
        const key = JSON.stringify(its);
        const question = JSON.stringify([key, inputs.pose]);
        if (question === asked) return false;
        const elsewhere = key !== place;
        const scene = elsewhere ? snug.scene(its.car, its.place, its.options) : state.scene;
        place = key;
        asked = question;
        wanted = inputs;
        since = sinceStill = wayless = performance.now();
        Object.assign(state, { scene, pose: inputs.pose ?? usualPose(inputs, scene), exact: null, proved: null, soFar: null, trouble: "" });
        // Out of a bay: the map covers headings from the car's to the road's.
        const heading = goalOf(inputs) === "road" && "heading" in scene.parked ? { heading: scene.parked.heading } : {};
        map.set({ ...its, options: { ...its.options, ...heading } }, state.pose);
        if (elsewhere) Object.assign(state, { bounds: null, way: null, lookedAt: null, stale: false }, map.state()?.near ? {} : { painted: null });
        questions.abandon("park");
        searching = false;
        lookUp();
        look();
        soonExact(askExact);
        return true;
    };

    /** After drawing: the picture may show something else of the street, or more finely. */
    const again = () => {
        const slice = listener.slice(state.pose.heading);
        if (slice && !map.looking() && JSON.stringify(slice) !== painted) look();
    };
    /** What is shown: never one with more changes than another that is known. */
    const way = (): Counted | null | undefined => {
        const { exact, proved } = state;
        if (exact) return exact.maneuver;
        return proved?.maneuver && changes(proved.maneuver) < changes(state.way) ? proved.maneuver : state.way;
    };
    return { state, times, ask, again, released, way, map };
}
