// The solver for JavaScript: types of snug.mjs. Lengths are metres, angles radians. Cars, slots and answers are the objects
// of the command's JSON, key by key (docs/formats.md). Every question throws an Error whose message says what is wrong with
// the input and what would be right; a question about valid input never throws.
//
//     import load from "./snug.mjs";
//     const snug = await load();
//     const answer = snug.entry("renault-zoe", { length: 4.5, width: 2.0 });
//     console.log(answer.direction_changes, answer.entry_ranges, answer.maneuver?.moves);
//
// Questions answer before they return: ask long ones (fewest, leave, park) in a worker, which can be ended.

/** A car of the catalogue by name, or what a car file says of it (docs/formats.md). */
export type CarLike = string | (CarShape & Steering & { name?: string; wheelbase: number });

/** Front and rear may be given as overhangs or by the length; points [x, y] are about the middle of the rear axle. */
type CarShape =
    | { outline: [number, number][] }
    | {
          width: number;
          front?: number;
          rear?: number;
          length?: number;
          front_overhang?: number;
          rear_overhang?: number;
          corner_radius?: number | { front: number; rear: number };
      };

interface CarLengths {
    name?: string;
    width: number;
    front: number;
    rear: number;
    wheelbase: number;
}
type Steering =
    | { max_steer: number }
    | { max_steer_deg: number }
    | { turning_radius: number }
    | { curb_to_curb: number }
    | { wall_to_wall: number };

export interface Car extends CarLengths {
    max_steer: number;
    /** Of a car that is no rectangle. */
    outline?: [number, number][];
}

export interface SlotLike {
    length: number;
    width: number;
    side?: "right" | "left";
    corner?: [number, number];
    heading?: number;
    /** How much deeper than the entry side the neighbours begin. */
    front_setback?: number;
    rear_setback?: number;
    /** A low curb stops the wheels only. */
    curb?: "high" | "low";
}
/** As it was asked for; setbacks and a low curb only where there are any. */
export type Slot = Required<Pick<SlotLike, "length" | "width" | "side" | "corner" | "heading">> &
    Pick<SlotLike, "front_setback" | "rear_setback" | "curb">;

export interface Pose {
    x: number;
    y: number;
    heading: number;
}

export interface Move {
    direction: "backward" | "forward";
    steering: "left" | "right" | "straight";
    /** Positive to the left. */
    steering_angle: number;
    length: number;
    start: Pose;
    end: Pose;
    /** `index`: which corner of an outline. */
    contact: { car: string; obstacle: string; index?: number } | null;
}

export interface Maneuver {
    direction_changes: number;
    length: number;
    swept: { x_min: number; x_max: number; y_min: number; y_max: number };
    entry: Pose;
    goal: Pose;
    moves: Move[];
}

export interface HeadingRange {
    heading_min: number;
    heading_max: number;
    direction_changes: number;
    subrange: number;
}

interface Common {
    clearance?: number;
    /** At the curb, where it differs from the clearance. */
    curb_clearance?: number;
    enter?: "backward" | "forward";
    /** What counts as parked: at most so far off parallel, its nearest point at most so far from the curb. */
    parked?: { heading?: number; curb?: number };
    max_changes?: number | null;
}

export interface EntryOptions extends Common {
    min_range?: number;
    /** Show that no heading is missed, the usual; `false` leaves that out, which takes a tenth of the time. */
    prove?: boolean;
    /** Told the part done, 0 to 1; returning false gives the question up. */
    progress?: (part: number) => boolean | void;
}

export interface EntryAnswer {
    schema: 1;
    car: Car;
    slot: Slot;
    strategy: "max-steer";
    max_changes: number | null;
    /** Null when the question was given up. */
    parkable: boolean | null;
    direction_changes?: number;
    /** The three of a proof: unless `prove` is false. */
    proved?: boolean;
    undecided?: { heading_min: number; heading_max: number }[];
    /** None parks with so many: where the car cannot park. */
    proved_changes?: number;
    entry_ranges: HeadingRange[];
    maneuver?: Maneuver;
}

export interface FewestProgress {
    lower_bound: number;
    direction_changes?: number;
    spacing: number;
    part: number;
}

export interface FewestOptions extends Common {
    resolution?: number;
    /** Seconds. */
    time_limit?: number;
    roomiest?: boolean;
    /** Told whenever a bound or the lattice changes; returning false ends with the bounds found so far. */
    progress?: (so_far: FewestProgress) => boolean | void;
}

interface Bounds {
    direction_changes?: number;
    proved: boolean;
    lower_bound: number;
    maneuver?: Maneuver;
}

export interface FewestAnswer extends Bounds {
    schema: 1;
    car: Car;
    slot: Slot;
    strategy: "fewest";
    max_changes: number | null;
    /** Null when undecided. */
    parkable: boolean | null;
    entry_ranges: [];
}

export interface LeaveAnswer extends Bounds {
    schema: 1;
    car: Car;
    slot: Slot;
}

export interface MinSlotOptions extends Common {
    /** One of the two: the slot's width, to find its length, or the other way round. */
    width?: number;
    length?: number;
    min_range?: number;
    strategy?: "max-steer" | "fewest";
    front_setback?: number;
    rear_setback?: number;
    curb?: "high" | "low";
    /** "max-steer": show also below which size nothing parks; the row then has `length_lower`, and `open` between. */
    prove?: boolean;
    /** For "fewest". */
    resolution?: number;
    precision?: number;
}

export interface MinSlotRow {
    max_changes: number;
    /** What was asked for is null where nothing will do. */
    width: number | null;
    length: number | null;
    entry_heading?: number | null;
    /** "fewest", or with `prove`: parking is proved impossible in any shorter, or narrower, slot but those in `open`. */
    length_lower?: number;
    width_lower?: number;
    /** With `prove`: sizes that park as well, or of which nothing is known. */
    open?: { length_min?: number; length_max?: number; width_min?: number; width_max?: number }[];
}

/** A car of a public data sheet. */
export interface SheetCar extends Car {
    /** Publisher and title of what has the lengths. */
    sheet: string;
    /** As printed, and which circle that is, as far as it is said. */
    circle: string;
}

export interface MaxSteerRun {
    outcome: "parked" | "no-entry" | "stuck" | "never-touches" | "too-many-changes";
    /** What was driven, however it ended. */
    maneuver?: Maneuver;
}

/** A bay at a street: `length` along the parked car, `width` across it, at `angle` to the street. */
export interface StreetLike extends SlotLike {
    /** From 0, parallel, to a quarter turn. */
    angle?: number;
    /** From the entry side to a wall beyond; null or nothing: none. */
    road?: number | null;
    /** How far beyond the slot the rear axle may go. */
    stretch?: number;
}

/** Any place, as a scene file says it (docs/formats.md). */
export interface Scene {
    obstacles: ([number, number][] | { polygon: [number, number][]; low?: boolean; name?: string })[];
    parked:
        | { inside: [number, number][]; heading: number; heading_tolerance?: number }
        | { pose: [number, number, number]; tolerance: [number, number, number] };
    start: [number, number, number];
    region?: { x_min: number; x_max: number; y_min: number; y_max: number };
}

/** Where the car is to stand: in the bay (the usual), or out of it on the road. */
interface Goal {
    goal?: "bay" | "road";
}

export interface ParkOptions extends FewestOptions, Goal {
    /** Without it, where the scene says, or beside the front neighbour; past a bay. */
    start?: Pose;
}

/** A maneuver that begins anywhere; of each move also what the car is nearest to at its end. */
export interface ParkManeuver extends Omit<Maneuver, "swept" | "entry"> {
    start: Pose;
    moves: (Move & { nearest?: { car: string; obstacle: string; distance: number } })[];
}

export interface ParkAnswer {
    schema: 1;
    car: Car;
    slot?: Required<Pick<StreetLike, "length" | "width" | "side" | "corner" | "heading" | "angle" | "stretch">> &
        StreetLike;
    scene?: Scene;
    start: Pose;
    max_changes: number;
    /** Null when undecided. */
    parkable: boolean | null;
    direction_changes?: number;
    proved: boolean;
    lower_bound: number;
    /** No number of changes will do. */
    impossible?: true;
    spacing: number;
    maneuver?: ParkManeuver;
    /** With more changes, each much shorter or ending straighter. */
    alternatives?: ParkManeuver[];
}

export interface ParkMapOptions extends Goal {
    clearance?: number;
    curb_clearance?: number;
    enter?: "backward" | "forward";
    parked?: { heading?: number; curb?: number };
    /** Of the lattice; 0 or nothing: 8 cm, or what a small turning circle needs. */
    spacing?: number;
    max_changes?: number;
    /** Of the cars that come along; nothing: the street's. */
    heading?: number;
    /** A pose to know of before all others: `known` is told of it what the map says, long before that is done. */
    first?: { pose: Pose; known: (bounds: MapBounds, way: Maneuver | null) => void };
}

export interface MapBounds {
    where: "free" | "blocked" | "outside";
    lower_bound: number;
    impossible: boolean;
    proved: boolean;
    /** A maneuver has so many. */
    direction_changes?: number;
    /** How it begins. */
    first?: "forward" | "backward";
}

/** From every pose, with how few changes the car parks. Call delete() when it is no longer needed. */
export interface ParkMap {
    at(pose: Pose): MapBounds;
    /** Null where none is known, and where the car is parked. */
    maneuver(pose: Pose): Maneuver | null;
    /**
     * At the middles of columns x rows fields, row by row from the least y: lower bounds and demonstrated counts.
     * -1: outside, -2: the car meets something, 32767: no number will do, or none is known.
     */
    slice(
        heading: number,
        box: { x_min: number; x_max: number; y_min: number; y_max: number },
        columns: number,
        rows: number,
    ): { lower: Int16Array; upper: Int16Array };
    /** For another worker: `unpackParkMap` has the same map there in milliseconds. Of use to the same version only. */
    packed(): Uint8Array;
    readonly fingerprint: string;
    readonly middle_heading: number;
    readonly spacing: number;
    readonly bytes: number;
    delete(): void;
}

export interface Snug {
    readonly version: string;
    /** The paper's five cars. */
    cars(): Car[];
    sheetCars(): SheetCar[];
    /** All entry headings that park with the fewest changes, or with at most `max_changes`: Problems 1 and 2. */
    entry(car: CarLike, slot: SlotLike, options?: EntryOptions): EntryAnswer;
    /** The paper's strategy from one entry heading. */
    maxSteer(car: CarLike, slot: SlotLike, heading: number, options?: Common): MaxSteerRun;
    /** The smallest slot: Problem 3. */
    minSlot(car: CarLike, options: MinSlotOptions): MinSlotRow;
    /** The fewest changes over all maneuvers, with proof. */
    fewest(car: CarLike, slot: SlotLike, options?: FewestOptions): FewestAnswer;
    /** The fewest changes to get out from where the car is parked. */
    leave(
        car: CarLike,
        slot: SlotLike,
        gaps: { front: number; curb: number; heading?: number },
        options?: FewestOptions,
    ): LeaveAnswer;
    /** From anywhere into a street's bay or a scene, with the fewest changes. */
    park(car: CarLike, place: StreetLike | Scene, options?: ParkOptions): ParkAnswer;
    /** The same from every pose, swept once. */
    parkMap(car: CarLike, place: StreetLike | Scene, options?: ParkMapOptions): ParkMap;
    /**
     * The map that another worker packed, for the same car, place and options; damaged or other bytes throw. Unpack none that a
     * stranger made.
     */
    unpackParkMap(car: CarLike, place: StreetLike | Scene, options: ParkMapOptions, packed: Uint8Array): ParkMap;
    /** A street's bay and its usual start, or a scene, with everything a picture needs. */
    scene(car: CarLike, place: StreetLike | Scene, options?: ParkOptions): Scene;
    /** What a scene file says, or a case of TPCAP where the name ends in .csv. */
    readScene(text: string, name: string): Scene;
    /** A car as it is understood, with `front`, `rear` and `max_steer`. */
    car(car: CarLike): Car;
    /** How much the slot lacks to hold the car at all. */
    shortfall(car: CarLike, slot: SlotLike, options?: { clearance?: number }): { length: number; width: number };
}

/** Loads the solver. In a browser snug.wasm is fetched from beside the module unless `locateFile` says otherwise. */
export default function load(options?: {
    locateFile?: (name: string) => string;
    wasmBinary?: ArrayBuffer;
    instantiateWasm?: (
        imports: WebAssembly.Imports,
        done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void,
    ) => object;
}): Promise<Snug>;
