// A maneuver over time, as the library's trajectory() has it: pieces of one direction and steering are driven from rest to
// rest, and between them the steering turns while the car stands.
import type { Track } from "./geometry";

/** The library's usual limits: a walk among parked cars. */
export const limits = { speed: 1, acceleration: 0.5, steeringRate: 0.5 };

interface Phase {
    at: number;
    seconds: number;
    leg: number;
    /** Driven before it. */
    from: number;
    /** Nothing where the steering turns. */
    length: number;
    steer: [number, number];
}

export interface Instant {
    distance: number;
    /** [m/s], never negative. */
    speed: number;
    steer: number;
    leg: number;
}

export interface Timeline {
    seconds: number;
    at(time: number): Instant;
    /** When that leg begins to roll. */
    startOf(leg: number): number;
}

export function timeline({ legs }: Track): Timeline {
    const { speed: most, acceleration: a, steeringRate } = limits;
    const phases: Phase[] = [];
    let now = 0;
    let steer = 0;
    for (let i = 0; i < legs.length; ++i) {
        const first = legs[i]!;
        let length = first.length;
        const leg = i;
        const same = (next: typeof first) => next.backward === first.backward && next.steer === first.steer;
        while (i + 1 < legs.length && (legs[i + 1]!.length === 0 || same(legs[i + 1]!))) length += legs[++i]!.length;
        if (length === 0) continue;
        const turning = Math.abs(first.steer - steer) / steeringRate;
        if (turning > 0) phases.push({ at: now, seconds: turning, leg, from: first.from, length: 0, steer: [steer, first.steer] });
        now += turning;
        steer = first.steer;
        const top = Math.min(most, Math.sqrt(length * a));
        const seconds = (2 * top) / a + Math.max(0, length - (top * top) / a) / top;
        phases.push({ at: now, seconds, leg, from: first.from, length, steer: [steer, steer] });
        now += seconds;
    }

    const at = (time: number): Instant => {
        const phase = phases.filter((one) => one.at <= time).at(-1) ?? phases[0];
        if (!phase) return { distance: 0, speed: 0, steer: 0, leg: 0 };
        const t = Math.min(Math.max(time - phase.at, 0), phase.seconds);
        const { leg, from, length, seconds } = phase;
        if (length === 0)
            return { distance: from, speed: 0, steer: phase.steer[0] + (phase.steer[1] - phase.steer[0]) * (t / seconds), leg };
        const top = Math.min(most, Math.sqrt(length * a));
        const gaining = top / a;
        const left = seconds - t;
        const driven = t < gaining ? (a * t * t) / 2 : left < gaining ? length - (a * left * left) / 2 : (top * gaining) / 2 + top * (t - gaining);
        const distance = from + Math.min(driven, length);
        // A piece may hold several legs.
        let inside = leg;
        while (inside + 1 < legs.length && legs[inside + 1]!.from <= distance && legs[inside + 1]!.from < from + length) ++inside;
        return { distance, speed: Math.min(a * t, top, a * left), steer: phase.steer[1], leg: inside };
    };
    const startOf = (leg: number) => {
        const rolling = phases.filter((one) => one.length > 0 && one.leg <= leg).at(-1);
        if (!rolling || rolling.leg === leg) return rolling?.at ?? 0;
        // Inside a piece: when so much of it is driven.
        let [low, high] = [rolling.at, rolling.at + rolling.seconds];
        for (let i = 0; i < 50; ++i) {
            const middle = (low + high) / 2;
            if (at(middle).distance < legs[leg]!.from) low = middle;
            else high = middle;
        }
        return high;
    };
    return { seconds: now, at, startOf };
}
