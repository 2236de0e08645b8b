// The map of slots: extra width against extra length, coloured by direction changes, with the slot as a point to drag.
import { countColor, moreColor } from "./colors";
import { byId, html, set, setText } from "./dom";
import { clamp } from "./geometry";
import { plural } from "./words";
import { more, type MapGrid } from "./questions";

export const grid: MapGrid = { columns: 48, rows: 32, extraLength: 1.92, extraWidth: 0.96 };

export function createMap(id: string, label: string, move: (extraLength: number, extraWidth: number) => void) {
    const root = byId(id);
    const canvas = html("canvas", { width: grid.columns, height: grid.rows, role: "img", "aria-label": label });
    const point = html("button", { type: "button", class: "point" });
    const state = html("p", { class: "state" });
    const field = html("div", { class: "field" }, canvas, point);
    const tick = (axis: string, part: number, text: string) => {
        const mark = html("span", { class: `tick ${axis}` }, text);
        mark.style.setProperty("--at", String(part));
        return mark;
    };
    for (const part of [0, 0.25, 0.5, 0.75, 1])
        field.append(
            tick("x", part, (part * grid.extraLength).toFixed(2)),
            tick("y", part, (part * grid.extraWidth).toFixed(2)),
        );
    field.append(html("span", { class: "axis x" }, "longer than the car [m]"), html("span", { class: "axis y" }, "wider [m]"));
    root.append(field, state);
    const paint = canvas.getContext("2d")!;
    const counts = new Int16Array(grid.columns * grid.rows).fill(-2);
    let extra = { length: 0, width: 0 };

    const describe = () => {
        const column = Math.floor((extra.length / grid.extraLength) * grid.columns);
        const row = Math.floor((extra.width / grid.extraWidth) * grid.rows);
        const inside = column >= 0 && row >= 0 && column < grid.columns && row < grid.rows;
        const count = inside ? counts[row * grid.columns + column]! : -2;
        const words = count === -2 ? "" : count < 0 ? ": no way in" : count === more ? ": more changes than are counted" : `: ${count} ${plural(count)}`;
        set(point, {
            "aria-label": `Slot ${extra.length.toFixed(2)} m longer and ${extra.width.toFixed(2)} m wider than the car${words}. Arrow keys change it.`,
        });
    };

    const show = (extraLength: number, extraWidth: number) => {
        extra = { length: extraLength, width: extraWidth };
        point.style.setProperty("--x", String(clamp(extraLength / grid.extraLength, 0, 1)));
        point.style.setProperty("--y", String(clamp(extraWidth / grid.extraWidth, 0, 1)));
        describe();
    };

    const clear = () => {
        counts.fill(-2);
        // Blank, not hatched: nothing is known yet.
        paint.fillStyle = getComputedStyle(root).getPropertyValue("--sheet");
        paint.fillRect(0, 0, grid.columns, grid.rows);
        setText(state, "computing …");
        set(root, { "data-done": null });
    };

    const fill = (cells: [number, number, number, number, number][], part: number) => {
        for (const [column, row, columns, rows, count] of cells) {
            const top = grid.rows - row - rows;
            paint.clearRect(column, top, columns, rows);
            if (count === more) {
                paint.fillStyle = moreColor;
                paint.fillRect(column, top, columns, rows);
            } else if (count >= 0) {
                paint.fillStyle = countColor(count);
                paint.fillRect(column, top, columns, rows);
            }
            for (let r = row; r < row + rows; ++r) counts.fill(count, r * grid.columns + column, r * grid.columns + column + columns);
        }
        describe();
        setText(state, part < 1 ? `computing … ${Math.round(100 * part)} %` : "");
        set(root, { "data-done": part === 1 ? "true" : null });
    };

    let dragging = false;
    const moveTo = (event: PointerEvent) => {
        const frame = canvas.getBoundingClientRect();
        const x = clamp((event.clientX - frame.left) / frame.width, 0, 1) * grid.extraLength;
        const y = clamp(1 - (event.clientY - frame.top) / frame.height, 0, 1) * grid.extraWidth;
        move(Math.round(x * 200) / 200, Math.round(y * 200) / 200);
    };
    field.addEventListener("pointerdown", (event) => {
        if (event.button !== 0) return;
        event.preventDefault();
        dragging = true;
        field.setPointerCapture(event.pointerId);
        point.focus({ preventScroll: true });
        moveTo(event);
    });
    field.addEventListener("pointermove", (event) => dragging && moveTo(event));
    for (const end of ["pointerup", "pointercancel"]) field.addEventListener(end, () => (dragging = false));
    point.addEventListener("keydown", (event) => {
        const by = event.shiftKey ? 0.1 : 0.01;
        const step = { ArrowLeft: [-by, 0], ArrowRight: [by, 0], ArrowUp: [0, by], ArrowDown: [0, -by] }[event.key];
        if (!step) return;
        event.preventDefault();
        move(extra.length + step[0]!, extra.width + step[1]!);
    });
    return { show, clear, fill, busy: () => dragging, state: (text: string) => setText(state, text) };
}
