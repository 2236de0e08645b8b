// The solver in the browser answers as the native one, maneuvers included: the same words,
// counts and bits of every number.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { differences, native, random } from "./browser.mjs";
import { site } from "./site.mjs";

const seed = 6;
const total = process.env.SNUG_SOAK ? 2000 : 300; // each starts the command once
const folder = mkdtempSync(join(tmpdir(), "snug-web-"));
after(() => rmSync(folder, { recursive: true }));

/** Asks the page's solver many questions at once. */
const inBrowser = (page, asked) =>
    page.evaluate(
        (questions) =>
            questions.map(({ name, values }) => {
                try {
                    return window.snugPage.snug[name](...values);
                } catch (error) {
                    return { error: error.message };
                }
            }),
        asked,
    );

test(`${total} random questions have the same answers as the command's`, { timeout: 600_000 }, async () => {
    const page = await site.page();
    const next = random(seed);
    const between = (low, high) => Number((low + (high - low) * next()).toFixed(5));
    const catalogue = await page.evaluate(() => window.snugPage.snug.cars());
    const cars = catalogue.map((car) => ({ car, argument: car.name }));
    for (let i = 0; i < 25; ++i) {
        const car = { name: `random-${i}`, width: between(1.4, 2.2), front: between(2.8, 4.4), rear: between(0.4, 1.3) };
        car.wheelbase = Number((car.front * (0.7 + 0.15 * next())).toFixed(5));
        car.max_steer = between(0.4, 0.85);
        const argument = join(folder, `${car.name}.json`);
        writeFileSync(argument, JSON.stringify(car));
        cars.push({ car, argument });
    }
    const questions = Array.from({ length: total }, (_, i) => {
        const { car, argument } = cars[Math.floor(next() * cars.length)];
        const length = Number((car.front + car.rear + between(0.25, 1.9)).toFixed(5));
        const width = Number((car.width + between(0.05, 0.8)).toFixed(5));
        const side = next() < 0.5 ? "left" : "right";
        const enter = next() < 0.2 ? "forward" : "backward";
        const clearance = next() < 0.3 ? between(0.01, 0.05) : 0;
        const slot = ["--car", argument, "--length", length, "--width", width, "--side", side];
        const how = ["--enter", enter, "--clearance", clearance];
        if (i % 20 === 0)
            return {
                name: "fewest",
                values: [car, { length, width, side }, { enter, clearance, resolution: 0.01, max_changes: 12 }],
                words: ["entry", ...slot, ...how, "--strategy", "fewest", "--resolution", 0.01, "--max-changes", 12],
            };
        if (i % 20 === 10)
            return {
                name: "leave",
                values: [car, { length, width, side }, { front: 0.12, curb: 0.03 }, { resolution: 0.01, max_changes: 12 }],
                words: ["leave", ...slot, "--gap-front", 0.12, "--gap-curb", 0.03, "--resolution", 0.01, "--max-changes", 12],
            };
        if (i % 25 === 3) {
            const road = between(car.width + 0.5, 5);
            return {
                name: "park",
                values: [car, { length, width, side, road }, { enter, clearance, resolution: 0.04, max_changes: 6 }],
                words: ["park", ...slot, "--road", road, ...how, "--resolution", 0.04, "--max-changes", 6],
            };
        }
        if (i % 10 === 5) {
            const max_changes = Math.floor(next() * 8);
            const prove = i % 100 === 5;
            return {
                name: "minSlot",
                values: [car, { width, max_changes, clearance, prove }],
                words: ["min-slot", "--car", argument, "--width", width, "--max-changes", max_changes, "--clearance", clearance, ...(prove ? ["--proof", "smaller"] : [])],
            };
        }
        const max_changes = next() < 0.3 ? Math.floor(next() * 12) : undefined;
        const limit = max_changes === undefined ? [] : ["--max-changes", max_changes];
        return {
            name: "entry",
            values: [car, { length, width, side }, { enter, clearance, max_changes }],
            words: ["entry", ...slot, ...how, ...limit],
        };
    });
    const answers = [];
    for (let i = 0; i < total; i += 100) answers.push(...(await inBrowser(page, questions.slice(i, i + 100))));
    const failures = [];
    questions.forEach(({ name, words }, i) => {
        let expected = native(...words);
        if (name === "minSlot" && expected.rows) [expected] = expected.rows;
        delete expected.any_maneuver; // the command's own, where full steering cannot park
        delete expected.start_tolerance; // and where it can
        const found = differences(answers[i], expected);
        if (found.length > 0) failures.push(`seed ${seed}, number ${i}: snug ${words.join(" ")}\n  ${found.slice(0, 4).join("\n  ")}`);
    });
    assert.equal(failures.length, 0, `${failures.length} differ:\n${failures.slice(0, 12).join("\n")}`);
});

test("the map of a street bounds what the command answers", async () => {
    const page = await site.page();
    const street = { length: 5.2, width: 2, road: 3.5 };
    const box = { x_min: -6, x_max: 4, y_min: -1, y_max: 3 };
    const poses = [
        { x: 2, y: 1.75, heading: 0 },
        { x: -3, y: 1.5, heading: 0.1 },
        { x: 1, y: 0.3, heading: 0 },
        { x: 0, y: 1.75, heading: 3 },
    ];
    const map = await page.evaluate(
        ([street, box, poses]) => {
            const of = window.snugPage.snug.parkMap("renault-zoe", street);
            const { lower, upper } = of.slice(0, box, 50, 20);
            const at = (x, y) => of.at({ x: box.x_min + ((x + 0.5) / 50) * 10, y: box.y_min + ((y + 0.5) / 20) * 4, heading: 0 });
            const result = {
                bounds: poses.map((pose) => of.at(pose)),
                ways: poses.map((pose) => of.maneuver(pose)),
                slice: [Array.from(lower), Array.from(upper)],
                samples: [[7, 12], [30, 14], [25, 2], [49, 19]].map(([x, y]) => [y * 50 + x, at(x, y)]),
                fingerprint: of.fingerprint,
            };
            of.delete();
            return result;
        },
        [street, box, poses],
    );
    assert.deepEqual(map.bounds.map((bounds) => bounds.where), ["free", "free", "blocked", "outside"]);
    for (const [i, pose] of poses.slice(0, 2).entries()) {
        const bounds = map.bounds[i];
        const said = native("park", "--car", "renault-zoe", "--length", 5.2, "--width", 2, "--road", 3.5, "--from", `${pose.x},${pose.y},${pose.heading}`);
        assert.ok(bounds.lower_bound <= said.direction_changes && said.lower_bound <= bounds.direction_changes);
        assert.ok(map.ways[i].direction_changes <= bounds.direction_changes);
        assert.equal(map.ways[i].moves[0].direction, bounds.first);
    }
    assert.deepEqual(map.ways.slice(2), [null, null]);
    const [lower, upper] = map.slice;
    assert.ok(lower.every((count, i) => count <= upper[i]) && lower.length === 1000);
    for (const [i, bounds] of map.samples)
        assert.equal(lower[i], { blocked: -2, outside: -1 }[bounds.where] ?? (bounds.impossible ? 32767 : bounds.lower_bound));
    assert.match(map.fingerprint, /^\d+$/);
});

test("a map that was packed says the same once unpacked; what is damaged or of something else is refused", async () => {
    const page = await site.page();
    const [same, refused] = await page.evaluate(() => {
        const { snug } = window.snugPage;
        const of = ["renault-zoe", { length: 5.2, width: 2, road: 3.5 }, { spacing: 0.12, max_changes: 9 }];
        const map = snug.parkMap(...of);
        const packed = map.packed();
        const again = snug.unpackParkMap(...of, packed);
        const poses = Array.from({ length: 300 }, (_, i) => ({ x: -8 + 0.05 * i, y: 3 * Math.sin(i) + 0.5, heading: Math.sin(3 * i) }));
        const all = (one) => JSON.stringify([one.bytes, one.fingerprint, poses.map((pose) => [one.at(pose), one.maneuver(pose)])]);
        const same = all(map) === all(again);
        const refuse = (...how) => {
            try {
                snug.unpackParkMap(...how);
                return "";
            } catch (error) {
                return error.message;
            }
        };
        const damaged = packed.slice();
        damaged[packed.length >> 1] ^= 4;
        const refused = [
            refuse(...of, damaged),
            refuse(...of, packed.slice(0, packed.length >> 1)),
            refuse(...of, new Uint8Array(3)),
            refuse(...of, "map"),
            refuse(of[0], { ...of[1], width: 2.1 }, of[2], packed),
            refuse(of[0], of[1], { ...of[2], spacing: 0.1 }, packed),
        ];
        map.delete();
        again.delete();
        return [same, refused];
    });
    assert.ok(same);
    for (const [i, words] of [/damaged/, /damaged|too soon/, /too soon|version/, /Uint8Array/, /another one/, /another one/].entries()) assert.match(refused[i], words);
});

test("errors are JavaScript's, with the core's messages", async () => {
    const page = await site.page();
    const slot = { length: 5, width: 2 };
    const asked = await inBrowser(page, [
        { name: "entry", values: ["renault-zoo", slot] },
        { name: "entry", values: [{ width: 1.8 }, slot] },
        { name: "entry", values: ["renault-zoe", { length: -1, width: 2 }] },
        { name: "entry", values: ["renault-zoe", { length: "5", width: 2 }] },
        { name: "entry", values: ["renault-zoe", slot, { enter: "sideways" }] },
        { name: "fewest", values: ["renault-zoe", slot, { max_changes: 1.5 }] },
        { name: "maxSteer", values: ["renault-zoe", slot, 9] },
        { name: "minSlot", values: ["renault-zoe", {}] },
        { name: "leave", values: ["renault-zoe", slot, { front: 9, curb: 0 }] },
        { name: "park", values: ["renault-zoe", { ...slot, road: -1 }] },
        { name: "park", values: ["renault-zoe", { obstacles: [] }] },
        { name: "parkMap", values: ["renault-zoe", slot, { spacing: 1 }] },
    ]);
    for (const answer of asked) assert.match(answer.error ?? "no error", /\w+ .* \w+/);
    assert.match(asked[0].error, /did you mean "renault-zoe"/);
    assert.match(asked[2].error, /slot length is -1 m, but must lie between/);
    assert.equal(await page.evaluate(() => {
        try {
            window.snugPage.snug.entry("mid-size", { length: -1, width: 2 });
        } catch (error) {
            return error instanceof Error;
        }
    }), true);
});
