// The map of the street, from every pose: swept in a worker, coarse first and then finer, and looked up there. Two workers
// take turns: one answers with the newest map while the other sweeps the next. The coarse one is handed over to the page once
// nothing is dragged: then it is looked up in the frame that asks.
import type { Car, Maneuver, MapBounds, ParkMap, Pose, Snug } from "snug";
import { mostInStreet, type Asker, type PlaceCase, type Slice } from "./questions";

export interface Look {
    pose: Pose;
    slice: Slice | null;
}
export interface Seen {
    bounds: MapBounds;
    way: Maneuver | null;
    counts: { lower: Int16Array; upper: Int16Array } | null;
}

interface Listener {
    /** What the map of the place that was set last will say of the pose that was named then: it is swept still. */
    first(pose: Pose, seen: Pick<Seen, "bounds" | "way">): void;
    /** A map is there, of what was asked last or of a moment before; looks are answered from it. */
    ready(): void;
    seen(look: Look, seen: Seen): void;
    failed(sentence: string): void;
    /** Something is being dragged: no time to take a map over. */
    busy(): boolean;
}

/** To take over a larger map would hold up a frame. [bytes] */
const largestOwn = 12e6;

/** Lattices, as parts of the coarsest. */
const levels = [1, 1 / 2, 1 / 3];
/** A 32nd of the turning radius at most: the library takes no coarser one. */
const coarsest = ({ wheelbase, max_steer }: Car) => Math.min(0.999 / 32 * (wheelbase / Math.tan(max_steer)), 0.16);

/** Alike where only lengths differ, as while a street is dragged: the map of a moment ago says something of it still. */
const kin = ({ car, place, options }: PlaceCase) => JSON.stringify([car, options, "obstacles" in place ? place : [place.angle, place.side, place.curb]]);

export function createStreetMap(snug: Snug, questions: Asker, listener: Listener) {
    let wanted: PlaceCase | null = null;
    let stands: Pose | null = null;
    let key = "";
    let sweeping: { key: string; level: number } | null = null;
    let front = 0;
    /** What the front worker holds. */
    let held: { key: string; kin: string; spacing: number; milliseconds: number; level: number } | null = null;
    /** How long maps and looks took, for the tests and the bench. [ms] */
    const times = { maps: [] as number[], taken: [] as number[], looks: [] as number[], own: [] as number[] };

    const sweep = (level: number, after = false) => {
        if (!wanted) return;
        const mine = { key, level };
        const first = level === 0 ? stands : null;
        const swept = { ...wanted, spacing: coarsest(wanted.car) * levels[level]! };
        sweeping = mine;
        const back = 1 - front;
        questions.ask(`street-${back}`, "street-map", { ...swept, first, hand_over: level === 0 ? largestOwn : 0 }, (told) => {
            if ("bounds" in told) {
                if (first && mine.key === key) listener.first(first, told);
                return;
            }
            sweeping = null;
            if ("error" in told) {
                if (mine.key === key && level === 0) listener.failed(told.error);
            } else {
                front = back;
                const { spacing, milliseconds } = told;
                held = { key: mine.key, kin: kin(swept), level, spacing, milliseconds };
                if (level === 0) times.maps.push(told.milliseconds);
                if (told.packed) given = { key: mine.key, swept, packed: told.packed };
                takeOver();
                looking = 0; // what the other worker was asked is asked again of this one
                listener.ready();
            }
            if (mine.key !== key) sweep(0);
            else if (!("error" in told) && level + 1 < levels.length) sweep(level + 1);
        }, after);
    };

    /** Nothing is dragged any more: what is swept for a place that was passed on the way is in the way. */
    const hurry = () => {
        if (sweeping?.level !== 0 || sweeping.key === key) return;
        questions.abandon(`street-${1 - front}`);
        // The other worker is warm, and its look takes some milliseconds; a new one takes half as long again for all.
        front = 1 - front;
        held = null;
        looking = 0;
        sweep(0, true);
    };

    let own: { key: string; map: ParkMap } | null = null;
    let given: { key: string; swept: PlaceCase & { spacing: number }; packed: Uint8Array } | null = null;
    const takeOver = () => {
        if (!given || listener.busy()) return;
        const before = performance.now();
        const { key: its, swept, packed } = given;
        const { car, place, options, spacing } = swept;
        given = null;
        if (its !== key) return; // of a place that was left
        own?.map.delete();
        own = null;
        try {
            own = { key: its, map: snug.unpackParkMap(car, place, { ...options, spacing, max_changes: mostInStreet }, packed) };
        } catch {
            // Out of memory, at worst: the workers' maps go on answering.
        }
        times.taken.push(performance.now() - before);
    };
    /** From the page's own map; null where that is of another place. */
    const at = (pose: Pose): Pick<Seen, "bounds" | "way"> | null => {
        if (own?.key !== key) return null;
        const before = performance.now();
        const found = { bounds: own.map.at(pose), way: own.map.maneuver(pose) };
        times.own.push(performance.now() - before);
        return found;
    };

    /** The place is this one now, and the car stands there. */
    const set = (next: PlaceCase, pose: Pose) => {
        stands = pose;
        const its = JSON.stringify(next);
        if (its === key) return;
        key = its;
        wanted = next;
        // While something is dragged the first map of a moment ago is worth its end; what only refines it is not.
        if (sweeping?.level === 0) return;
        questions.abandon(`street-${1 - front}`);
        sweep(0);
    };

    let looking = 0; // which look is under way
    let looks = 0;
    let next: Look | null = null;
    /** The newest look is answered; those in between are left out. */
    const look = (asked: Look) => {
        if (!held || looking) {
            next = asked;
            return;
        }
        next = null;
        const mine = (looking = ++looks);
        const before = performance.now();
        questions.ask(`street-${front}`, "look", asked, (told) => {
            if (mine !== looking) return;
            looking = 0;
            times.looks.push(performance.now() - before);
            if ("error" in told) listener.failed(told.error);
            else listener.seen(asked, told);
            if (next) look(next);
        });
    };
    return {
        set,
        look,
        at,
        takeOver,
        hurry,
        looking: () => looking !== 0,
        times,
        /** Null: none yet. `current`: of the place that was set last; `near`: of one like it. */
        state: () => held && { ...held, current: held.key === key, near: !!wanted && held.kin === kin(wanted), finest: held.level === levels.length - 1, own: own?.key === key },
    };
}
