// The answers to what is set: full steering at once, in the frame that asks, and proved a moment later by a worker; all
// maneuvers from a worker, by and by.
import type { EntryAnswer, FewestAnswer, FewestProgress, HeadingRange, Snug } from "snug";
import { drivingOf, slotOf, type Inputs } from "./inputs";
import { later } from "./later";
import type { Asker } from "./questions";

interface Listener {
    /** There is something new to show. */
    changed(): void;
    /** The answer for the chosen strategy stands. */
    settled(): void;
    failed(sentence: string): void;
    /** Something is being dragged: no time for more than the answer. */
    busy(): boolean;
}

export function createAnswers(snug: Snug, questions: Asker, listener: Listener) {
    const answers = {
        entry: null as EntryAnswer | null,
        fewest: null as FewestAnswer | null,
        bounds: null as FewestProgress | null,
        /** For the fan: the best ranges, and a little later those of more changes. */
        ranges: [] as HeadingRange[],
        /** These are the last slot's still: this one takes more than a few changes, if it can be entered at all. */
        late: false,
    };
    /** How long the solver took in the last frames, for the tests. [ms] */
    const frameTimes: number[] = [];
    let asked = "";
    const soonFewest = later(120);
    const soonSettled = later(60);
    const soonRanges = later(80);
    const soonProof = later(60);

    const askFewest = (inputs: Inputs) =>
        questions.ask("fewest", "fewest", { car: inputs.car, slot: slotOf(inputs), ...drivingOf(inputs) }, (told) => {
            if ("error" in told) {
                listener.failed(told.error);
                return;
            }
            if ("so_far" in told) answers.bounds = told.so_far;
            else {
                answers.fewest = told.answer;
                listener.settled();
            }
            listener.changed();
        });

    // That a car cannot park is known only after up to 200 changes from many headings, which takes longer than a frame has.
    // So a drag looks for few changes in each frame, and where there is no such way in a worker looks further: at one slot
    // at a time, then at the newest. Its answer comes a frame or two later; the last one is shown until then.
    const few = 12;
    let looking = false;
    let next: (() => void) | null = null;
    const lookFurther = (inputs: Inputs, question: string) => {
        if (looking) {
            next = () => lookFurther(inputs, question);
            return;
        }
        looking = true;
        questions.ask("entry", "entry", { car: inputs.car, slot: slotOf(inputs), ...drivingOf(inputs), prove: false }, (told) => {
            looking = false;
            if (question === asked) {
                if ("error" in told) listener.failed(told.error);
                else {
                    const fits = (answer: EntryAnswer | null) => answer?.direction_changes !== undefined;
                    const same = !fits(told.answer) && !fits(answers.entry);
                    Object.assign(answers, { entry: told.answer, ranges: told.answer.entry_ranges, late: false });
                    soonSettled(() => inputs.strategy === "fewest" || listener.settled());
                    if (!same) listener.changed();
                }
            }
            const then = next;
            next = null;
            then?.();
        });
    };

    /** True where the question is a new one. Throws the solver's sentence, and keeps the last answers, where it has none. */
    const ask = (inputs: Inputs): boolean => {
        const question = JSON.stringify([inputs.car, slotOf(inputs), drivingOf(inputs), inputs.strategy]);
        if (question === asked) return false;
        const before = performance.now();
        const [{ car }, slot, quick] = [inputs, slotOf(inputs), { ...drivingOf(inputs), prove: false }];
        const late = listener.busy() && snug.entry(car, slot, { ...quick, max_changes: few }).direction_changes === undefined;
        const entry = late ? null : snug.entry(car, slot, quick);
        frameTimes.push(performance.now() - before);
        if (frameTimes.length > 600) frameTimes.shift();
        asked = question;
        Object.assign(answers, { fewest: null, bounds: null, late });
        next = null;
        if (entry) Object.assign(answers, { entry, ranges: entry.entry_ranges });
        else lookFurther(inputs, question);
        questions.abandon("fewest");
        const all = inputs.strategy === "fewest";
        soonFewest(() => all && askFewest(inputs));
        soonSettled(() => all || answers.late || listener.settled());
        askRanges(inputs);
        questions.abandon("proof");
        askProof(inputs, question);
        return true;
    };

    /** Once nothing is dragged: that no heading is missed. What it changes is rare, and then it is right. */
    const askProof = (inputs: Inputs, question: string) =>
        soonProof(() => {
            if (inputs.strategy === "fewest" || question !== asked) return;
            if (listener.busy() || answers.late) {
                askProof(inputs, question);
                return;
            }
            questions.ask("proof", "entry", { car: inputs.car, slot: slotOf(inputs), ...drivingOf(inputs), prove: true }, (told) => {
                if (question !== asked || "error" in told) return;
                const same = <T>(one: T, other: T) => JSON.stringify(one) === JSON.stringify(other);
                const before = answers.entry;
                answers.entry = told.answer;
                // What is shown stays the same object: the player does not begin again.
                if (before && same(before.maneuver, told.answer.maneuver)) told.answer.maneuver = before.maneuver;
                if (!before || !same(before.entry_ranges, told.answer.entry_ranges)) {
                    answers.ranges = told.answer.entry_ranges;
                    askRanges(inputs);
                    listener.settled();
                }
                listener.changed();
            });
        });

    const askRanges = (inputs: Inputs) =>
        soonRanges(() => {
            const best = answers.entry?.direction_changes;
            if (best === undefined || answers.late || inputs.strategy === "fewest" || listener.busy()) return;
            const more = { ...drivingOf(inputs), max_changes: best + 6, prove: false };
            answers.ranges = snug.entry(inputs.car, slotOf(inputs), more).entry_ranges;
            listener.changed();
        });

    /** What is said to be the answer: null while it is searched for. */
    const final = (inputs: Inputs) => (inputs.strategy === "fewest" ? answers.fewest : answers.late ? null : answers.entry);
    return { answers, frameTimes, ask, askRanges, final };
}
export type Answers = ReturnType<typeof createAnswers>["answers"];
