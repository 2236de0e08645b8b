// Handles in a picture: knobs and cars that are dragged, or moved by keys where they have the focus.
import { set, svg } from "./dom";
import type { Point } from "./geometry";
import { round, type Pen } from "./view";

export const arrowsAlong = "M-3-3.5L-7 0L-3 3.5M3-3.5L7 0L3 3.5";
export const arrowsAcross = "M-3.5-3L0-7L3.5-3M-3.5 3L0 7L3.5 3";

/** A knob with a sign on it, and more room around it for fingers. */
export const knob = (what: string, label: string, sign: string) =>
    svg(
        "g",
        { class: `grip grip-${what}`, role: "slider", tabindex: 0, "aria-label": label, "data-grip": what },
        svg("circle", { r: 22, class: "reach" }),
        svg("circle", { r: 13, class: "knob" }),
        svg("path", { class: "arrows", d: sign }),
    );

interface Listener<What extends string, Held> {
    /** At a point of the ground: what is known of it while it is held; null where it cannot be grabbed now. */
    grab(what: What, at: Point): Held | null;
    move(held: Held, at: Point): void;
    released(): void;
    /** False where that key means nothing. */
    key(what: What, event: KeyboardEvent): boolean;
}

/** Returns what is held now. `gripOf`: what takes the focus. Whatever else moves with a handle names it as its data-grip-for. */
export function createHandles<What extends string, Held>(
    root: SVGSVGElement,
    ground: Pen["ground"],
    gripOf: Record<What, SVGElement>,
    listener: Listener<What, Held>,
): () => Held | null {
    let held: Held | null = null;
    const pointer = (event: PointerEvent): Point => {
        const frame = root.getBoundingClientRect();
        return ground(event.clientX - frame.left, event.clientY - frame.top);
    };
    const what = (target: EventTarget | null): What | null => {
        const element = target instanceof Element ? target.closest("[data-grip], [data-grip-for]") : null;
        return (element?.getAttribute("data-grip") ?? element?.getAttribute("data-grip-for") ?? null) as What | null;
    };

    root.addEventListener("pointerdown", (event) => {
        const grabbed = what(event.target);
        if (!grabbed || event.button !== 0) return;
        held = listener.grab(grabbed, pointer(event));
        if (held === null) return;
        event.preventDefault();
        root.setPointerCapture(event.pointerId);
        root.classList.add("dragging");
        gripOf[grabbed].focus({ preventScroll: true });
    });
    root.addEventListener("pointermove", (event) => held !== null && listener.move(held, pointer(event)));
    for (const end of ["pointerup", "pointercancel"])
        root.addEventListener(end, () => {
            if (held === null) return;
            held = null;
            root.classList.remove("dragging");
            listener.released();
        });
    root.addEventListener("keydown", (event) => {
        const focused = what(event.target);
        if (focused && listener.key(focused, event)) event.preventDefault();
    });
    return () => held;
}

/** The picture's size in pixels, now and whenever it changes; a hidden one has none. */
export const watchSize = (root: SVGSVGElement, resized: (size: { width: number; height: number }) => void) =>
    new ResizeObserver(([entry]) => {
        const { width, height } = entry!.contentRect;
        if (width > 0) set(root, { viewBox: `0 0 ${round(width)} ${round(height)}` });
        resized({ width, height });
    }).observe(root);
