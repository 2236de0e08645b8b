// The shortest slot of this width that does with one change fewer; where none is needed, the shortest that still needs none.
import { byId, setText } from "./dom";
import { drivingOf, slotOf, type Inputs } from "./inputs";
import type { Asker } from "./questions";
import { plural } from "./words";

const say = (large: string, note: string) => {
    setText(byId("shorter"), large);
    setText(byId("shorter-note"), note);
};

const metres = (more: number) => (more < 0.1 ? `${Math.round(more * 1000)} mm` : `${more.toFixed(3)} m`);

export function createShorter(questions: Asker) {
    /** The question has changed; its answer is not known yet. */
    const wait = () => {
        questions.abandon("min-slot");
        say("…", "");
    };

    /** `count`: of the answer; where the car does not fit, any count will do. */
    const ask = (inputs: Inputs, count: number | undefined) => {
        const { width, length, car, strategy } = inputs;
        const titles = { undefined: "Shortest slot of this width", 0: "Shortest slot for no change" } as Record<string, string>;
        setText(byId("shorter-title"), titles[String(count)] ?? "One change fewer");
        const most = count === undefined ? (strategy === "fewest" ? 12 : 200) : Math.max(count - 1, 0);
        const { length: _, side: __, ...slot } = slotOf(inputs);
        questions.ask("min-slot", "min-slot", { car, ...slot, ...drivingOf(inputs), max_changes: most, strategy }, (told) => {
            if ("error" in told) {
                say("–", told.error);
                return;
            }
            const enough = told.row.length;
            if (enough === null) {
                say("no length will do", `No slot ${width.toFixed(3)} m wide is long enough; it would have to be wider.`);
                return;
            }
            const long = Math.ceil(enough * 1000 - 1e-6) / 1000;
            const more = long - length;
            const changes = count === undefined ? "" : ` for ${most} ${plural(most)}`;
            say(`${more < 0 ? "−" : "+"} ${metres(Math.abs(more))}`, `${long.toFixed(3)} m long${changes}.`);
        });
    };
    return { wait, ask };
}
