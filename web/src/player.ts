// Plays a maneuver: time goes on, the car drives; it stands still for a moment where it changes direction.
import type { Car, Maneuver, Move } from "snug";
import { byId, html, set, setText } from "./dom";
import { clamp, degrees, legAt, poseAt, type Track } from "./geometry";

const speed = 0.55; // [m/s]
const pause = 0.45; // [s], at a direction change
const wheelTurns = 1.5; // of the steering wheel from straight to full

interface Played {
    car: Car;
    maneuver: Maneuver;
    track: Track;
}

/** "backward, full left" */
function how(car: Car, { direction, steering, steering_angle }: Move) {
    const full = steering !== "straight" && Math.abs(steering_angle) > car.max_steer * (1 - 1e-9);
    return `${direction}, ${full ? "full " : ""}${steering}`;
}

const wheelAngle = ({ steering_angle }: Move) => `${degrees(Math.abs(steering_angle)).toFixed(1)}°`;

/** The command's words for them. */
const obstacles: Record<string, string> = {
    "rear side": "rear neighbour",
    "front side": "front neighbour",
    "rear corner": "rear slot corner",
    "front corner": "front slot corner",
};

export function createPlayer(show: (pose: { x: number; y: number; heading: number }, steer: number) => void) {
    const button = byId<HTMLButtonElement>("play");
    const scrub = byId<HTMLInputElement>("scrub");
    const wheel = byId<SVGGElement>("wheel");
    const now = byId("now");
    const detail = byId("now-detail");
    const list = byId("moves");
    let played: Played | null = null;
    let distance = 0;
    let leg = 0;
    let rest = 0;
    let running = false;
    let last = 0;

    const place = () => {
        if (!played) return;
        const { car, track, maneuver } = played;
        const current = track.legs[leg]!;
        show(poseAt(car, { legs: [current], length: track.length }, distance), current.steer);
        scrub.value = String(Math.round((1000 * distance) / track.length));
        const move = maneuver.moves[leg]!;
        set(wheel, { transform: `rotate(${((-move.steering_angle / car.max_steer) * wheelTurns * 360).toFixed(1)})` });
        const parked = distance >= track.length;
        setText(now, parked ? "Parked" : `${leg + 1} of ${track.legs.length}: ${how(car, move)}`);
        const driven = clamp(distance - current.from, 0, current.length);
        setText(detail, `wheels ${wheelAngle(move)} · ${driven.toFixed(3)} of ${move.length.toFixed(3)} m`);
        set(scrub, { "aria-valuetext": `move ${leg + 1} of ${track.legs.length}, ${driven.toFixed(2)} metres` });
        if (list.children[leg]?.getAttribute("aria-current") !== "step") {
            [...list.children].forEach((row, i) => set(row, { "aria-current": i === leg ? "step" : null }));
            intoView(list.children[leg]);
        }
        document.documentElement.dataset.pose = JSON.stringify(poseAt(car, track, distance));
    };

    const halt = () => {
        running = false;
        setText(button, "Play");
        set(button, { "data-state": "paused" });
    };

    const goTo = (to: number, at?: number) => {
        if (!played) return;
        distance = clamp(to, 0, played.track.length);
        leg = Math.min(at ?? legAt(played.track, distance), played.track.legs.length - 1);
        rest = 0;
        place();
    };

    const tick = (time: number) => {
        if (!running || !played) return;
        const passed = Math.min((time - last) / 1000, 0.1) * Number(byId<HTMLSelectElement>("speed").value);
        last = time;
        if (rest > 0) rest -= passed;
        else {
            const { track } = played;
            const current = track.legs[leg]!;
            const end = current.from + current.length;
            distance = Math.min(distance + passed * speed, end);
            if (distance >= end && leg + 1 < track.legs.length) {
                rest = track.legs[leg + 1]!.backward === current.backward ? 0 : pause;
                ++leg;
            } else if (distance >= end) {
                distance = track.length;
                place();
                halt();
                return;
            }
            place();
        }
        requestAnimationFrame(tick);
    };

    button.addEventListener("click", () => {
        if (!played) return;
        if (running) {
            halt();
            return;
        }
        if (distance >= played.track.length) goTo(0);
        running = true;
        setText(button, "Pause");
        set(button, { "data-state": "playing" });
        last = performance.now();
        requestAnimationFrame(tick);
    });
    scrub.addEventListener("input", () => {
        halt();
        if (played) goTo((Number(scrub.value) / 1000) * played.track.length);
    });
    byId("previous").addEventListener("click", () => {
        halt();
        const current = played?.track.legs[leg];
        if (current) goTo(distance > current.from + 1e-9 ? current.from : (played!.track.legs[leg - 1]?.from ?? 0));
    });
    byId("next").addEventListener("click", () => {
        halt();
        const current = played?.track.legs[leg];
        if (current) goTo(current.from + current.length);
    });

    const contactWords = ({ contact }: Move, isLast: boolean) =>
        contact ? `${contact.car} meets ${obstacles[contact.obstacle] ?? contact.obstacle}` : isLast ? "stop: parked" : "stop";

    // The list may be longer than its place: it says how many moves there are, shows the one under way, and fades out below
    // while there are more.
    const showMore = () => set(list, { "data-more": list.scrollTop + list.clientHeight < list.scrollHeight - 4 ? "" : null });
    list.addEventListener("scroll", showMore, { passive: true });
    new ResizeObserver(showMore).observe(list);
    const intoView = (row: Element | undefined) => {
        if (!row || list.scrollHeight <= list.clientHeight) return;
        const [place, seen] = [row.getBoundingClientRect(), list.getBoundingClientRect()];
        if (place.top < seen.top) list.scrollTop += place.top - seen.top;
        else if (place.bottom > seen.bottom - place.height) list.scrollTop += place.bottom - seen.bottom + place.height;
    };

    const showList = (next: Played) => {
        const { moves } = next.maneuver;
        setText(byId("moves-count"), moves.length === 1 ? "one move" : `${moves.length} moves`);
        list.replaceChildren(
            ...moves.map((move, i) => {
                const step = html(
                    "button",
                    { type: "button" },
                    html("span", { class: `arrow ${move.direction}`, "aria-hidden": "true" }, move.direction === "backward" ? "←" : "→"),
                    html("span", { class: "how" }, how(next.car, move)),
                    html("span", { class: "angle" }, wheelAngle(move)),
                    html("span", { class: "far" }, `${move.length.toFixed(3)} m`),
                    html("span", { class: "until" }, contactWords(move, i === moves.length - 1)),
                );
                step.addEventListener("click", () => {
                    halt();
                    goTo(next.track.legs[i]!.from, i);
                });
                return html("li", {}, step);
            }),
        );
        list.scrollTop = 0;
        showMore();
    };

    let listing = 0;
    let loadedAt = -Infinity;
    /** A new maneuver, from its start; null where there is none. */
    const load = (next: Played | null) => {
        halt();
        played = next;
        for (const id of ["play", "scrub", "previous", "next"]) byId<HTMLButtonElement>(id).disabled = !next;
        byId("maneuver").hidden = !next;
        if (!next) {
            clearTimeout(listing);
            list.replaceChildren();
            setText(now, "No maneuver");
            setText(detail, "");
            delete document.documentElement.dataset.pose;
            set(wheel, { transform: null });
            return;
        }
        // While a slot is dragged, answers come in every frame: the list follows when there is time.
        clearTimeout(listing);
        const asked = performance.now();
        if (asked - loadedAt > 200) showList(next);
        else listing = window.setTimeout(() => (showList(next), place()), 150);
        loadedAt = asked;
        goTo(0, 0);
    };
    return { load, place };
}
