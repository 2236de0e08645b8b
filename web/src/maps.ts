// The two maps side by side: the paper's strategy and all maneuvers. They are computed once they are looked at.
import type { Car } from "snug";
import { legend } from "./colors";
import { byId, html } from "./dom";
import { drivingOf, type Inputs } from "./inputs";
import { later } from "./later";
import { createMap, grid } from "./map";
import type { Asker } from "./questions";

/** `move`: the slot was dragged to be so much longer and wider than the car. */
export function createMaps(questions: Asker, move: (extraLength: number, extraWidth: number) => void) {
    const maps = {
        "max-steer": createMap("map-max-steer", "Direction changes with full steering, by size of the slot", move),
        fewest: createMap("map-fewest", "Direction changes over all maneuvers, by size of the slot", move),
    };
    const kinds = ["max-steer", "fewest"] as const;
    const colors = () =>
        legend.map(({ color, label }) => {
            const swatch = html("span", { class: "swatch", "aria-hidden": "true" });
            swatch.style.background = color;
            return html("li", {}, swatch, label);
        });
    const other = (kind: string, label: string) => html("li", {}, html("span", { class: `swatch ${kind}`, "aria-hidden": "true" }), label);
    const entries = other("line", "the paper’s entry positions");
    entries.id = "legend-entries";
    byId("street-legend").append(
        ...colors().slice(0, -2),
        other("more", "more than 20, or none known"),
        other("impossible", "impossible"),
        entries,
    );
    byId("legend").append(
        ...colors(),
        other("more", "more than 12, of all maneuvers"),
        other("none", "impossible"),
    );

    let wanted: (ReturnType<typeof drivingOf> & { car: Car }) | null = null;
    let shown = "";
    let due = false;
    let seen = false;
    const soon = later(350);

    const ask = (strategy: (typeof kinds)[number]) =>
        questions.ask(`map-${strategy}`, "map", { ...wanted!, grid, strategy }, (told) => {
            if ("error" in told) maps[strategy].state(told.error);
            else {
                maps[strategy].fill(told.cells, told.part);
                if (told.part === 1 && strategy === "max-steer") ask("fewest");
            }
        });
    const askSoon = () =>
        soon(() => {
            if (!due || !seen) return;
            due = false;
            ask("max-steer");
        });
    new IntersectionObserver((entries) => {
        seen = entries.some((one) => one.isIntersecting);
        askSoon();
    }).observe(byId("map-max-steer"));

    const show = (inputs: Inputs) => {
        const { car } = inputs;
        for (const kind of kinds) maps[kind].show(inputs.length - car.front - car.rear, inputs.width - car.width);
        wanted = { car, ...drivingOf(inputs) };
        const question = JSON.stringify(wanted);
        if (question === shown) return;
        shown = question;
        for (const kind of kinds) {
            questions.abandon(`map-${kind}`);
            maps[kind].clear();
        }
        due = true;
        askSoon();
    };
    return { show, busy: () => kinds.some((kind) => maps[kind].busy()) };
}
