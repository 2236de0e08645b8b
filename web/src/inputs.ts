// What a person can set: read from fields and links, checked, and written back as a link or a command line.
import type { Car } from "snug";
import { clamp, degrees, radians } from "./geometry";

export interface Inputs {
    car: Car;
    length: number;
    width: number;
    side: "right" | "left";
    clearance: number;
    enter: "backward" | "forward";
    strategy: "max-steer" | "fewest";
    /** The entry heading looked at [rad]; null: the best. */
    heading: number | null;
}

export const slotOf = ({ length, width, side }: Inputs) => ({ length, width, side });
export const drivingOf = ({ clearance, enter }: Inputs) => ({ clearance, enter });

export type NumberField =
    | "length"
    | "width"
    | "clearance"
    | "heading"
    | "car-width"
    | "car-front"
    | "car-rear"
    | "car-wheelbase"
    | "car-steer";

interface Limits {
    what: string;
    low: number;
    high: number;
    unit: string;
}

/** What the page takes and can show; the command takes more. */
export const limits: Record<NumberField, Limits> = {
    length: { what: "The slot’s length", low: 0.5, high: 40, unit: "m" },
    width: { what: "The slot’s width", low: 0.3, high: 10, unit: "m" },
    clearance: { what: "The clearance", low: 0, high: 1, unit: "m" },
    heading: { what: "The entry heading", low: 0, high: 90, unit: "°" },
    "car-width": { what: "The car’s width", low: 0.3, high: 6, unit: "m" },
    "car-front": { what: "The front, measured from the rear axle,", low: 0.3, high: 25, unit: "m" },
    "car-rear": { what: "The rear overhang", low: 0.05, high: 12, unit: "m" },
    "car-wheelbase": { what: "The wheelbase", low: 0.3, high: 20, unit: "m" },
    "car-steer": { what: "The largest steering angle", low: 5, high: 80, unit: "°" },
};

/** The nearest number the page takes, without noise from arithmetic. */
export const within = (field: NumberField, value: number) => clamp(Number(value.toFixed(6)), limits[field].low, limits[field].high);

/** The number typed, or a sentence that says what is wrong with it. */
export function parseNumber(field: NumberField, typed: string): number | string {
    const { what, low, high, unit } = limits[field];
    const text = typed.trim().replace(",", ".");
    const range = `between ${low} and ${high} ${unit}`;
    if (text === "") return `${what} is missing; give a number ${range}.`;
    if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d{1,3})?$/i.test(text)) return `${what} must be a number ${range}.`;
    const value = Number(text);
    return value >= low && value <= high ? value : `${what} must lie ${range}.`;
}

/** A number as a person would write it, without noise from arithmetic. */
export const plain = (value: number, digits = 6) => String(Number(value.toFixed(digits)));

const carFields = {
    "car-width": "width",
    "car-front": "front",
    "car-rear": "rear",
    "car-wheelbase": "wheelbase",
} as const;

export function fieldValue(inputs: Inputs, field: NumberField): number | null {
    if (field === "heading") return inputs.heading === null ? null : degrees(inputs.heading);
    if (field === "car-steer") return degrees(inputs.car.max_steer);
    if (field === "length" || field === "width" || field === "clearance") return inputs[field];
    return inputs.car[carFields[field]];
}

/** The inputs with one number changed; a changed car has no name any more. */
export function withField(inputs: Inputs, field: NumberField, value: number): Inputs {
    if (field === "heading") return { ...inputs, heading: radians(value) };
    if (field === "length" || field === "width" || field === "clearance") return { ...inputs, [field]: value };
    const { name: _, ...car } = inputs.car;
    if (field === "car-steer") car.max_steer = radians(value);
    else car[carFields[field]] = value;
    return { ...inputs, car };
}

export const carNumberFields = ["car-width", "car-front", "car-rear", "car-wheelbase", "car-steer"] as const;

/** The part of a link after its #. */
export function toLink(inputs: Inputs): string {
    const link = new URLSearchParams();
    if (inputs.car.name) link.set("car", inputs.car.name);
    else for (const field of carNumberFields) link.set(field, plain(fieldValue(inputs, field)!, 9));
    link.set("length", plain(inputs.length));
    link.set("width", plain(inputs.width));
    if (inputs.side !== "right") link.set("side", inputs.side);
    if (inputs.enter !== "backward") link.set("enter", inputs.enter);
    if (inputs.clearance) link.set("clearance", plain(inputs.clearance));
    if (inputs.strategy !== "max-steer") link.set("strategy", inputs.strategy);
    if (inputs.heading !== null) link.set("heading", plain(degrees(inputs.heading), 9));
    return link.toString();
}

export interface Complaint {
    sentence: string;
    field?: NumberField;
}

/** What is good in a link, and sentences about what is not. */
export function fromLink(text: string, start: Inputs, catalogue: Car[]): { inputs: Inputs; complaints: Complaint[] } {
    let inputs = start;
    const complaints: Complaint[] = [];
    const link = new URLSearchParams(text.slice(0, 2000));
    const name = link.get("car");
    if (name !== null) {
        const car = catalogue.find((one) => one.name === name);
        if (car) inputs = { ...inputs, car };
        else complaints.push({ sentence: "The link names a car that is not in the catalogue." });
    }
    for (const field of Object.keys(limits) as NumberField[]) {
        const typed = link.get(field);
        if (typed === null) continue;
        const value = parseNumber(field, typed);
        if (typeof value === "number") inputs = withField(inputs, field, value);
        else complaints.push({ field, sentence: `In the link: ${value}` });
    }
    const words = { side: ["right", "left"], enter: ["backward", "forward"], strategy: ["max-steer", "fewest"] } as const;
    for (const [key, known] of Object.entries(words)) {
        const word = link.get(key);
        if (word === null) continue;
        if ((known as readonly string[]).includes(word)) inputs = { ...inputs, [key]: word };
        else complaints.push({ sentence: `In the link: “${key}” must be ${known.join(" or ")}.` });
    }
    return { inputs, complaints };
}

/** The same question for the command. */
export function commandLine(inputs: Inputs): string {
    const { car } = inputs;
    const words = ["snug entry", `--car ${car.name ?? "car.json"}`];
    words.push(`--length ${plain(inputs.length)}`, `--width ${plain(inputs.width)}`);
    if (inputs.side !== "right") words.push(`--side ${inputs.side}`);
    if (inputs.enter !== "backward") words.push(`--enter ${inputs.enter}`);
    if (inputs.clearance) words.push(`--clearance ${plain(inputs.clearance)}`);
    if (inputs.strategy !== "max-steer") words.push(`--strategy ${inputs.strategy}`);
    const file = car.name ? "" : `echo '${JSON.stringify(car)}' > car.json && `;
    return file + words.join(" ");
}
