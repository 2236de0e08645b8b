// Questions that take longer than a frame, and how they are asked: each kind has a worker of its own, and a new question
// of a kind ends the one before.
import type { Car, EntryAnswer, FewestAnswer, FewestProgress, Maneuver, MapBounds, MinSlotRow, ParkAnswer, Pose, Scene, SlotLike, StreetLike } from "snug";

interface Case {
    car: Car;
    clearance: number;
    enter: "backward" | "forward";
}

/** A map's count where it takes more changes than are counted. */
export const more = 32767;

export interface MapGrid {
    columns: number;
    rows: number;
    extraLength: number;
    extraWidth: number;
}

/** Maps of the street count up to so many changes. */
export const mostInStreet = 20;

/** A car and where it parks. */
export interface PlaceCase {
    car: Car;
    place: StreetLike | Scene;
    options: { clearance: number; enter: "backward" | "forward"; goal: "bay" | "road"; heading?: number };
}

/** The map's counts at one heading, at the middles of so many fields of a box. */
export interface Slice {
    heading: number;
    box: { x_min: number; x_max: number; y_min: number; y_max: number };
    columns: number;
    rows: number;
}

export interface Questions {
    fewest: {
        ask: Case & { slot: SlotLike };
        tell: { so_far: FewestProgress } | { answer: FewestAnswer };
    };
    entry: {
        ask: Case & { slot: SlotLike; prove: boolean };
        tell: { answer: EntryAnswer };
    };
    "min-slot": {
        ask: Case & Partial<SlotLike> & { max_changes: number; strategy: "max-steer" | "fewest" };
        tell: { row: MinSlotRow };
    };
    /** The fewest changes from one pose, with proof: mostly that and any such way are there long before the roomiest. */
    park: {
        ask: PlaceCase & { start: Pose };
        tell: { so_far: FewestProgress } | { proved: ParkAnswer } | { answer: ParkAnswer };
    };
    /**
     * From every pose: the worker keeps the map and answers looks; up to so many bytes it also hands it over, packed. What it
     * says of the pose under `first` is told before the rest is swept.
     */
    "street-map": {
        ask: PlaceCase & { spacing: number; hand_over: number; first: Pose | null };
        tell: { bounds: MapBounds; way: Maneuver | null } | { spacing: number; milliseconds: number; packed: Uint8Array | null };
    };
    look: {
        ask: { pose: Pose; slice: Slice | null };
        tell: { bounds: MapBounds; way: Maneuver | null; counts: { lower: Int16Array; upper: Int16Array } | null };
    };
    /**
     * Counts of cells, each given as [column, row, columns, rows, count]: -1 where the car cannot park, `more` where it takes more
     * changes than are counted. `part`: of the work.
     */
    map: {
        ask: Case & { grid: MapGrid; strategy: "max-steer" | "fewest" };
        tell: { cells: [number, number, number, number, number][]; part: number };
    };
}
export type Kind = keyof Questions;
export type Told<K extends Kind> = Questions[K]["tell"] | { error: string };

export type ToWorker = { module: WebAssembly.Module } | { id: number; kind: Kind; ask: unknown };
export interface FromWorker {
    id: number;
    told: unknown;
    last: boolean;
}

interface Lane {
    worker: Worker;
    busy: boolean;
    id: number;
}

export function asker(module: WebAssembly.Module) {
    const lanes = new Map<string, Lane>();
    let ids = 0;

    const begin = () => {
        const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
        worker.postMessage({ module } satisfies ToWorker);
        return worker;
    };
    /** One that is ready: to start takes longer than many an answer. */
    let spare: Worker | null = begin();
    const take = () => {
        const worker = spare ?? begin();
        spare = null;
        setTimeout(() => (spare ??= begin()), 100);
        return worker;
    };

    const abandon = (lane: string) => {
        const old = lanes.get(lane);
        if (old?.busy) {
            old.worker.terminate();
            lanes.delete(lane);
        }
    };

    /** `after`: what the lane is asked already is soon answered, to nobody; a new worker would take longer. */
    const ask = <K extends Kind>(lane: string, kind: K, question: Questions[K]["ask"], tell: (told: Told<K>) => void, after = false) => {
        if (!after) abandon(lane);
        let used = lanes.get(lane);
        if (!used) {
            used = { worker: take(), busy: false, id: 0 };
            lanes.set(lane, used);
        }
        const mine = used;
        mine.busy = true;
        mine.id = ++ids;
        mine.worker.onmessage = ({ data }: MessageEvent<FromWorker>) => {
            if (data.id !== mine.id) return;
            if (data.last) mine.busy = false;
            tell(data.told as Told<K>);
        };
        mine.worker.onerror = () => {
            mine.worker.terminate();
            if (lanes.get(lane) === mine) lanes.delete(lane);
            tell({ error: "the solver stopped; change the slot to try again" });
        };
        mine.worker.postMessage({ id: mine.id, kind, ask: question } satisfies ToWorker);
    };
    return { ask, abandon };
}
export type Asker = ReturnType<typeof asker>;
