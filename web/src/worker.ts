// Answers long questions away from the page, one at a time.
import type { Maneuver, MapBounds, ParkMap, Snug } from "snug";
import { more, mostInStreet, type FromWorker, type Kind, type Questions, type ToWorker } from "./questions";
import { start } from "./solver";

/** `given`: what the page has from then on, and the worker no more. */
type Tell = (told: unknown, last?: boolean, given?: ArrayBufferLike[]) => void;
type Answer<K extends Kind> = (snug: Snug, ask: Questions[K]["ask"], tell: (told: Questions[K]["tell"], ...rest: [last?: boolean, given?: ArrayBufferLike[]]) => void) => void;

const timeLimit = 60; // [s]
/** A proof that takes longer comes with the roomiest way. [s] */
const soon = 0.2;

const fewest: Answer<"fewest"> = (snug, { car, clearance, enter, slot }, tell) => {
    const answer = snug.fewest(
        car,
        slot,
        { clearance, enter, time_limit: timeLimit, progress: (so_far) => tell({ so_far }) },
    );
    tell({ answer }, true);
};

const entry: Answer<"entry"> = (snug, { car, clearance, enter, slot, prove }, tell) =>
    tell({ answer: snug.entry(car, slot, { clearance, enter, prove }) }, true);

const minSlot: Answer<"min-slot"> = (snug, { car, ...options }, tell) => tell({ row: snug.minSlot(car, options) }, true);

const park: Answer<"park"> = (snug, { car, place, options, start }, tell) => {
    const progress = (so_far: Parameters<NonNullable<NonNullable<Parameters<Snug["park"]>[2]>["progress"]>>[0]) => tell({ so_far });
    const quick = snug.park(car, place, { ...options, start, time_limit: soon, roomiest: false, progress });
    if (quick.proved) tell({ proved: quick });
    tell({ answer: snug.park(car, place, { ...options, start, time_limit: timeLimit, progress }) }, true);
};

let held: ParkMap | null = null;
const streetMap: Answer<"street-map"> = (snug, { car, place, options, spacing, hand_over, first: pose }, tell) => {
    const before = performance.now();
    held?.delete();
    held = null;
    const first = pose && { pose, known: (bounds: MapBounds, way: Maneuver | null) => tell({ bounds, way }) };
    held = snug.parkMap(car, place, { ...options, spacing, max_changes: mostInStreet, ...(first ? { first } : {}) });
    const packed = held.bytes <= hand_over ? held.packed() : null;
    tell({ spacing, milliseconds: performance.now() - before, packed }, true, packed ? [packed.buffer] : []);
};
const look: Answer<"look"> = (_, { pose, slice }, tell) => {
    if (!held) throw new Error("there is no map yet");
    const counts = slice && held.slice(slice.heading, slice.box, slice.columns, slice.rows);
    tell({ bounds: held.at(pose), way: held.maneuver(pose), counts }, true);
};

const map: Answer<"map"> = (snug, { car, clearance, enter, grid, strategy }, tell) => {
    const size = (column: number, row: number) => ({
        length: car.front + car.rear + ((column + 0.5) / grid.columns) * grid.extraLength,
        width: car.width + ((row + 0.5) / grid.rows) * grid.extraWidth,
    });
    type Cells = Questions["map"]["tell"]["cells"];
    if (strategy === "max-steer") {
        // From the roomy slots down, so that something useful is there at once.
        for (let row = grid.rows - 1; row >= 0; --row) {
            const cells: Cells = [];
            for (let column = 0; column < grid.columns; ++column) {
                const answer = snug.entry(car, size(column, row), { clearance, enter, prove: false });
                cells.push([column, row, 1, 1, answer.direction_changes ?? -1]);
            }
            tell({ cells, part: 1 - row / (grid.rows + 1) });
        }
        tell({ cells: [], part: 1 }, true);
        return;
    }
    // A larger slot is no harder over all maneuvers: a block whose opposite corners need the same holds that count.
    const known = new Map<number, number>();
    const most = 12;
    const count = (column: number, row: number) => {
        const key = row * grid.columns + column;
        let found = known.get(key);
        if (found === undefined) {
            const answer = snug.fewest(car, size(column, row), {
                clearance,
                enter,
                max_changes: most,
                resolution: (car.front + car.rear) / 1500,
                time_limit: 0.4,
                roomiest: false,
            });
            found = answer.direction_changes ?? more;
            known.set(key, found);
        }
        return found;
    };
    // How far: of each level of blocks its part; a level takes about three times as long as the one before.
    const levels = Math.ceil(Math.log2(Math.max(grid.columns, grid.rows)));
    let level = 0;
    let blocks = [[0, 0, grid.columns - 1, grid.rows - 1]];
    while (blocks.length > 0) {
        const cut: number[][] = [];
        for (const [i, [left, low, right, high]] of (blocks as [number, number, number, number][]).entries()) {
            const part = Math.min(0.99, 3 ** (level - levels) * (1 + (2 * i) / blocks.length) - 3 ** -levels);
            const hard = count(left, low);
            const easy = count(right, high);
            const whole = (value: number) => tell({ cells: [[left, low, right - left + 1, high - low + 1, value]], part });
            whole(hard === easy ? hard : easy);
            if (hard === easy || (left === right && low === high)) continue;
            const across = (left + right) >> 1;
            const up = (low + high) >> 1;
            if (left === right) cut.push([left, low, left, up], [left, up + 1, left, high]);
            else if (low === high) cut.push([left, low, across, low], [across + 1, low, right, low]);
            else
                cut.push(
                    [across + 1, up + 1, right, high],
                    [left, up + 1, across, high],
                    [across + 1, low, right, up],
                    [left, low, across, up],
                );
        }
        blocks = cut;
        ++level;
    }
    tell({ cells: [], part: 1 }, true);
};

const answers: { [K in Kind]: Answer<K> } = { fewest, entry, "min-slot": minSlot, map, park, "street-map": streetMap, look };

let snug: Promise<Snug>;
onmessage = async ({ data }: MessageEvent<ToWorker>) => {
    if ("module" in data) {
        snug = start(data.module);
        return;
    }
    const tell: Tell = (told, last = false, given = []) => postMessage({ id: data.id, told, last } satisfies FromWorker, { transfer: given as ArrayBuffer[] });
    try {
        (answers[data.kind] as (snug: Snug, ask: unknown, tell: Tell) => void)(await snug, data.ask, tell);
    } catch (error) {
        tell({ error: error instanceof Error ? error.message : String(error) }, true);
    }
};
