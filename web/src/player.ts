// Plays a maneuver as the car would drive it: over time, at a walk, the steering turning while it stands.
import type { Maneuver, Move, Pose } from "snug";
import { byId, html, set, setText } from "./dom";
import { clamp, degrees, poseAt, type Shape, type Track } from "./geometry";
import { timeline, type Timeline } from "./trajectory";

/** Turns of the steering wheel from straight to full. Not a half: left and right would look the same. */
const wheelTurns = 1.2;

interface Played {
    car: Shape & { max_steer: number };
    maneuver: Pick<Maneuver, "moves">;
    track: Track;
    /** Left in the track is right in the world. */
    mirrored: boolean;
    /** What the end is called. */
    end: string;
    /** How far the car is from the nearest thing. */
    near(pose: Pose): { distance: number; name: string } | null;
}

/** "backward, full left" */
function how(car: Played["car"], { direction, steering, steering_angle }: Move) {
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

export function createPlayer(show: (pose: Pose, steer: number) => void) {
    const button = byId<HTMLButtonElement>("play");
    const scrub = byId<HTMLInputElement>("scrub");
    const wheel = byId<SVGGElement>("wheel");
    const now = byId("now");
    const detail = byId("now-detail");
    const nearby = byId("now-near");
    const list = byId("moves");
    let played: Played | null = null;
    let times: Timeline = timeline({ legs: [], length: 0 });
    let time = 0;
    let running = false;
    let last = 0;

    const place = () => {
        if (!played) return;
        const { car, track, maneuver, mirrored, near, end } = played;
        const { distance, leg, steer, speed } = times.at(time);
        const current = track.legs[leg]!;
        const parked = time >= times.seconds;
        const pose = parked ? poseAt(car, track, track.length) : poseAt(car, { legs: [current], length: track.length }, distance);
        show(pose, steer);
        scrub.value = String(Math.round((1000 * time) / (times.seconds || 1)));
        const move = maneuver.moves[leg]!;
        set(wheel, { transform: `rotate(${((-steer / car.max_steer) * (mirrored ? -1 : 1) * wheelTurns * 360).toFixed(1)})` });
        setText(now, parked ? end : `${leg + 1} of ${track.legs.length}: ${how(car, move)}`);
        const driven = clamp(distance - current.from, 0, current.length);
        const gap = near(pose);
        const clock = `${time.toFixed(1)} of ${times.seconds.toFixed(1)} s · ${speed.toFixed(2)} m/s · wheels ${degrees(Math.abs(steer)).toFixed(1)}°`;
        setText(detail, clock);
        setText(nearby, gap ? `${gap.distance < 0.0005 ? "touches" : `${gap.distance.toFixed(3)} m to`} ${gap.name}` : "");
        set(scrub, { "aria-valuetext": `move ${leg + 1} of ${track.legs.length}, ${driven.toFixed(2)} metres` });
        if (list.children[leg]?.getAttribute("aria-current") !== "step") {
            [...list.children].forEach((row, i) => set(row, { "aria-current": i === leg ? "step" : null }));
            intoView(list.children[leg]);
        }
        document.documentElement.dataset.pose = JSON.stringify(pose);
    };

    const halt = () => {
        running = false;
        setText(button, "Play");
        set(button, { "data-state": "paused" });
    };

    const goTo = (to: number) => {
        time = clamp(to, 0, times.seconds);
        place();
    };

    const tick = (at: number) => {
        if (!running || !played) return;
        const passed = Math.min((at - last) / 1000, 0.1) * Number(byId<HTMLSelectElement>("speed").value);
        last = at;
        goTo(time + passed);
        if (time >= times.seconds) halt();
        else requestAnimationFrame(tick);
    };

    button.addEventListener("click", () => {
        if (!played) return;
        if (running) {
            halt();
            return;
        }
        if (time >= times.seconds) goTo(0);
        running = true;
        setText(button, "Pause");
        set(button, { "data-state": "playing" });
        last = performance.now();
        requestAnimationFrame(tick);
    });
    scrub.addEventListener("input", () => {
        halt();
        if (played) goTo((Number(scrub.value) / 1000) * times.seconds);
    });
    const legNow = () => times.at(time).leg;
    const endOf = (leg: number) => (leg + 1 < played!.track.legs.length ? times.startOf(leg + 1) : times.seconds);
    byId("previous").addEventListener("click", () => {
        halt();
        if (!played) return;
        const leg = legNow();
        goTo(times.startOf(time > times.startOf(leg) + 1e-6 ? leg : Math.max(0, leg - 1)));
    });
    byId("next").addEventListener("click", () => {
        halt();
        if (!played) return;
        const leg = legNow();
        // Where the steering turns before a move, the move is still to come.
        goTo(time < times.startOf(leg) - 1e-6 && leg > 0 ? times.startOf(leg) : endOf(leg));
    });

    const contactWords = ({ contact, nearest }: Move & { nearest?: { car: string; obstacle: string; distance: number } }, end: string | null, goesOn: boolean) =>
        goesOn
            ? "then turn the wheel"
            : contact
            ? `${contact.car} meets ${obstacles[contact.obstacle] ?? contact.obstacle}`
            : end !== null
              ? `stop: ${end.toLowerCase()}`
              : nearest
                ? `stop, ${nearest.distance.toFixed(2)} m from ${nearest.obstacle}`
                : "stop";

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
                    html("span", { class: "until" }, contactWords(move, i === moves.length - 1 ? next.end : null, move.direction === moves[i + 1]?.direction)),
                );
                step.addEventListener("click", () => {
                    halt();
                    goTo(times.startOf(i));
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
    const load = (next: Played | null, otherwise = "No maneuver") => {
        halt();
        played = next;
        times = timeline(next?.track ?? { legs: [], length: 0 });
        document.documentElement.dataset.seconds = String(times.seconds); // for the tests of the page
        for (const id of ["play", "scrub", "previous", "next"]) byId<HTMLButtonElement>(id).disabled = !next;
        byId("maneuver").hidden = !next;
        if (!next) {
            clearTimeout(listing);
            list.replaceChildren();
            setText(now, otherwise);
            setText(detail, "");
            setText(nearby, "");
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
        goTo(0);
    };
    return { load, place, pause: halt };
}
