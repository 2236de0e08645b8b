// The street as a person meets it: the car is dragged, turned, let go; what the page says is what the command says.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { differences, native, random } from "./browser.mjs";
import { choose, dragged, follow, inputs, middle, reachedByTab, screenshot, settled, site, text, touched, type, violations } from "./site.mjs";

const folder = mkdtempSync(join(tmpdir(), "snug-street-"));
after(() => rmSync(folder, { recursive: true }));

/** The exact answer to what is set now. */
const exact = async (page) => {
    await page.waitForFunction(() => window.snugPage.answer() !== null, null, { timeout: 120_000 });
    return page.evaluate(() => window.snugPage.answer());
};
const mapped = (page) => page.waitForFunction(() => window.snugPage.map.state()?.current && window.snugPage.parking.painted);
/** The words of the command the page offers. */
const words = async (page) => (await text(page, "command")).replace(/^snug /, "").split(" ");
const sameAsCommand = async (page, what) => {
    const found = await exact(page);
    const differ = differences(found, native(...(await words(page))));
    assert.deepEqual(differ, [], `${what}: snug ${(await words(page)).join(" ")}`);
    return found;
};
const drag = (page, grip, dx, dy) => dragged(page, "street", grip, [dx / 2, dy / 2], [dx, dy]);

test("the car dragged to ten poses: the map bounds the command's count, and the exact answer is the command's, bit for bit", { timeout: 900_000 }, async () => {
    const page = await site.page({ path: "#mode=street&length=5.4&width=2.1" });
    await mapped(page);
    const next = random(17);
    let free = 0;
    for (let i = 0; i < 40 && free < 10; ++i) {
        const [x, y] = await middle(page, "street", "car");
        const frame = await page.locator("#street").boundingBox();
        const to = [frame.x + frame.width * (0.2 + 0.6 * next()), frame.y + frame.height * (0.25 + 0.45 * next())];
        await drag(page, "car", to[0] - x, to[1] - y);
        await drag(page, "turn", 0, 60 * (next() - 0.5));
        await page.waitForFunction(() => window.snugPage.parking.lookedAt === window.snugPage.parking.pose);
        const bounds = await page.evaluate(() => window.snugPage.parking.bounds);
        if (bounds.where !== "free") {
            assert.equal(await text(page, "verdict"), "It cannot stand here");
            continue;
        }
        ++free;
        const found = await sameAsCommand(page, `pose ${i}`);
        // What was shown as proved before the roomiest way was there had the same count.
        const before = await page.evaluate(() => window.snugPage.parking.proved);
        if (before) assert.deepEqual([before.proved, before.direction_changes], [true, found.direction_changes]);
        assert.equal(await text(page, "count"), found.proved ? String(found.direction_changes) : `≤ ${found.direction_changes}`);
        assert.ok(bounds.lower_bound <= found.direction_changes);
        if (bounds.direction_changes !== undefined) assert.ok(bounds.direction_changes >= found.lower_bound);
    }
    assert.equal(free, 10);
});

test("while the car is dragged, the page's own map answers in the frame that asks, as the library's does", { timeout: 300_000 }, async () => {
    const page = await site.page({ path: "#mode=street&length=5.4&width=2.1" });
    await page.waitForFunction(() => window.snugPage.map.state()?.own);
    await page.evaluate(() => {
        const { snug } = window.snugPage;
        const car = snug.car("renault-zoe");
        const spacing = Math.min((0.999 / 32) * (car.wheelbase / Math.tan(car.max_steer)), 0.16);
        window.again = snug.parkMap(car, { length: 5.4, width: 2.1, road: 6 }, { spacing, max_changes: 20 });
    });
    const [x, y] = await middle(page, "street", "car");
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 8; ++i) {
        await page.mouse.move(x - 9 * i, y - 3 * i);
        const [now, alone] = await page.evaluate(
            () =>
                new Promise((done) =>
                    requestAnimationFrame(() => {
                        const { lookedAt, pose, bounds, way } = window.snugPage.parking;
                        const { again } = window;
                        done([{ current: lookedAt === pose, bounds, way }, { current: true, bounds: again.at(pose), way: again.maneuver(pose) }]);
                    }),
                ),
        );
        assert.deepEqual(differences(now, alone), [], `step ${i}`);
    }
    await page.mouse.up();
});

test("a neighbour put down: what is said of the car's pose before the rest is swept is what the whole map says, and right by the command", { timeout: 600_000 }, async () => {
    for (const path of ["#mode=street&length=5.4", "#mode=street&length=4.9", "#mode=street&angle=90&length=5&width=2.5"]) {
        const page = await site.page({ path });
        await mapped(page);
        // What workers tell of maps, in turn, and how the page stands then.
        await page.evaluate(() => {
            window.told = [];
            const { get, set } = Object.getOwnPropertyDescriptor(Worker.prototype, "onmessage");
            Object.defineProperty(Worker.prototype, "onmessage", {
                get,
                set(heard) {
                    set.call(this, (event) => {
                        heard(event);
                        const { id, told } = event.data;
                        const { parking, inputs } = window.snugPage;
                        if ("bounds" in told && !("counts" in told)) window.told.push({ id, ...told, said: parking.lookedAt === parking.pose && !parking.stale && parking.bounds, pose: parking.pose, place: JSON.stringify(inputs()) });
                        if ("packed" in told) window.told.push({ id, spacing: told.spacing });
                    });
                },
            });
        });
        for (const by of [-9, 4, -7]) {
            await drag(page, "rear", by, 0);
            const found = await sameAsCommand(page, `${path} by ${by}`);
            await mapped(page);
            const [first, whole] = await page.evaluate(() => {
                const { snug, parking, inputs } = window.snugPage;
                const { car, length, width, road, angle } = inputs();
                const at = window.told.findLastIndex((one) => one.bounds && one.place === JSON.stringify(inputs()));
                const { id, bounds, way, said, pose } = window.told[at];
                const { spacing } = window.told.slice(at).find((one) => one.id === id && one.spacing); // it came later
                const place = { length, width, road, ...(angle ? { angle: (angle * Math.PI) / 180 } : {}) };
                const map = snug.parkMap(car, place, { spacing, max_changes: 20 });
                const whole = { bounds: map.at(parking.pose), way: map.maneuver(parking.pose), said: map.at(parking.pose), pose: parking.pose };
                map.delete();
                return [{ bounds, way, said, pose }, whole];
            });
            assert.deepEqual(differences(first, whole), [], `${path} by ${by}`);
            const { bounds, way } = first;
            assert.ok(bounds.lower_bound <= found.direction_changes && (!bounds.proved || found.direction_changes === bounds.direction_changes), JSON.stringify(bounds));
            if (way) assert.ok(found.lower_bound <= way.direction_changes && way.direction_changes <= bounds.direction_changes);
        }
    }
});

test("every kind of place has the command's answer: at an angle, tail and nose first, both sides, in and out", { timeout: 900_000 }, async () => {
    const page = await site.page();
    const cases = [
        ["perpendicular", "backward", "right", "in"],
        ["perpendicular", "forward", "left", "in"],
        ["angled", "forward", "right", "in"],
        ["parallel", "backward", "left", "in"],
        ["parallel", "backward", "right", "out"],
        ["perpendicular", "backward", "right", "out"],
    ];
    for (const [kind, enter, side, way] of cases) {
        await choose(page, "kind", kind);
        await choose(page, "enter", enter);
        await choose(page, "side", side);
        await choose(page, "way", way);
        await sameAsCommand(page, `${kind} ${enter} ${side} ${way}`);
        // The map covers where the car stands, out of a bay too.
        await page.waitForFunction(() => window.snugPage.map.state()?.current && window.snugPage.parking.lookedAt === window.snugPage.parking.pose);
        assert.equal(await page.evaluate(() => window.snugPage.parking.bounds.where), "free", `${kind} ${way}`);
    }
});

test("unequal neighbours, a low curb, an open road and clearance have the command's answer", { timeout: 900_000 }, async () => {
    const page = await site.page({ path: "#mode=street&front-setback=0.3&rear-setback=0.1&curb=low&road=open&clearance=0.05&length=5.2" });
    assert.equal((await inputs(page)).road, null);
    const found = await sameAsCommand(page, "setbacks");
    assert.equal(found.slot.front_setback, 0.3);
    assert.equal(found.slot.curb, "low");
});

test("a car with rounded corners, from data-sheet numbers with units", { timeout: 900_000 }, async () => {
    const page = await site.page({ path: "#mode=street&length=5.3" });
    await page.locator("#dimensions summary").click();
    await type(page, "car-width", "1771 mm");
    await type(page, "front-overhang", "84 cm");
    await type(page, "turning-circle", "10,6 m");
    await type(page, "car-corner", "0.4");
    const { car } = await inputs(page);
    assert.ok(Math.abs(car.front - 3.428) < 1e-9 && car.width === 1.771 && car.corner_radius === 0.4, JSON.stringify(car));
    assert.match(await page.locator("#turning-circle").inputValue(), /^10[.,]6/);
    const file = join(folder, "rounded.json");
    writeFileSync(file, JSON.stringify(car));
    const found = await exact(page);
    const expected = native("park", "--car", file, "--length", 5.3, "--width", 2, "--road", 6);
    assert.deepEqual(differences(found, expected), []);
});

test("dragging neighbours, curb and far side changes the place, and the car stays where it is", async () => {
    const page = await site.page();
    await mapped(page);
    const start = await inputs(page);
    await drag(page, "rear", -40, 0);
    const longer = await inputs(page);
    assert.ok(longer.length > start.length + 0.3);
    await drag(page, "car", -20, -10);
    const [x, y] = await middle(page, "street", "car");
    await drag(page, "front", 30, 0);
    const front = await inputs(page);
    assert.ok(front.length > longer.length && front.pose.x < (await page.evaluate(() => 1e9)));
    await drag(page, "curb", 0, 20);
    assert.ok((await inputs(page)).width > front.width);
    await drag(page, "far", 0, 30);
    assert.ok((await inputs(page)).road < start.road);
    assert.ok(Math.hypot(x, y) > 0);
    await mapped(page);
});

test("the street is coloured by the map's counts at the car's heading, and anew when it turns", { timeout: 300_000 }, async () => {
    const page = await site.page();
    await mapped(page);
    const look = () =>
        page.evaluate(() => {
            const { slice, counts } = window.snugPage.parking.painted;
            return { heading: slice.heading, counts: [...new Set(counts.upper)], image: document.querySelector("#street image").getAttribute("href") };
        });
    const one = await look();
    assert.equal(one.heading, 0);
    assert.match(one.image, /^data:image\/png/);
    assert.ok(one.counts.some((count) => count === 0) && one.counts.some((count) => count > 1) && one.counts.includes(-2), String(one.counts));
    await page.locator('#street [data-grip="turn"]').focus();
    for (let i = 0; i < 3; ++i) await page.keyboard.press("ArrowUp");
    const turned = (3 * Math.PI) / 180;
    await page.waitForFunction((heading) => Math.abs(window.snugPage.parking.painted.slice.heading - heading) < 1e-3, turned);
    assert.notEqual((await look()).image, one.image);
    // The entry position of this heading is marked where the paper has it: the car's front right corner at the slot's.
    const apart = await page.evaluate((heading) => {
        // On the screen: from the dot, the car's front and half its width lead to the slot's front corner.
        const { front, width } = window.snugPage.inputs().car;
        const dot = document.querySelector(".entry-dot");
        const [ends] = document.querySelector("#street .neighbours .slot").getAttribute("d").matchAll(/M(\S+) (\S+)L(\S+) (\S+)L(\S+) (\S+)L/g);
        const [x1, y1, x2, y2, x3, y3] = ends.slice(1).map(Number);
        const scale = Math.hypot(x2 - x1, y2 - y1) / window.snugPage.inputs().length;
        const corner = [x3, y3]; // rear right, front right, front left
        const to = [
            Number(dot.getAttribute("cx")) + scale * (front * Math.cos(heading) + (width / 2) * Math.sin(heading)),
            Number(dot.getAttribute("cy")) - scale * (front * Math.sin(heading) - (width / 2) * Math.cos(heading)),
        ];
        return Math.hypot(to[0] - corner[0], to[1] - corner[1]);
    }, turned);
    assert.ok(apart < 1, `${apart} pixels`);
    // What is unknown, more than is counted, and impossible are told apart in words, too.
    assert.match(await text(page, "street-legend"), /more than 20, or none known.*impossible.*entry positions/);
    assert.ok(await page.locator("#legend-entries").isVisible());
    await page.locator("#show-map").uncheck();
    await settled(page);
    assert.equal(await page.locator("#street image").getAttribute("href"), null);
    // They are the paper's, of parallel slots: a bay has none, neither in the picture nor in the legend.
    await page.locator("#show-map").check();
    await choose(page, "kind", "perpendicular");
    assert.equal(await page.locator("#street .entry-line").count(), 0);
    assert.ok(await page.locator("#legend-entries").isHidden());
});

test("played as the trajectory has it: its time, its distances, a wheel that tells left from right", { timeout: 300_000 }, async () => {
    const page = await site.page();
    const { maneuver } = await exact(page);
    await settled(page);
    // Front wheels turn, rear ones do not: how a wheel's side lies on the screen.
    const wheels = () =>
        page.evaluate(() =>
            [...document.querySelectorAll("#street .vehicle .wheel")].map((wheel) => {
                const [, x1, y1, x2, y2] = /M(\S+) (\S+)L(\S+) (\S+)L/.exec(wheel.getAttribute("d")).map(Number);
                return Math.atan2(y1 - y2, x1 - x2);
            }),
        );
    const seconds = Number(await page.evaluate(() => document.documentElement.dataset.seconds));
    assert.ok(Math.abs(seconds - maneuver.seconds) < 1e-6, `${seconds} s and the command's ${maneuver.seconds} s`);
    const wheel = () => page.locator("#wheel").getAttribute("transform");
    const turns = new Map();
    for (let i = 0; i < maneuver.moves.length; ++i) {
        await page.locator("#moves li button").nth(i).click();
        const move = maneuver.moves[i];
        turns.set(move.steering, ((Number(/rotate\((.*)\)/.exec(await wheel())[1]) % 360) + 360) % 360);
        const [rear, , front] = await wheels();
        const turned = Math.abs(Math.atan2(Math.sin(front - rear), Math.cos(front - rear)));
        if (i > 0) assert.ok(Math.abs(turned - Math.abs(maneuver.moves[i].steering_angle)) < 0.1, `move ${i}: front wheels ${turned} rad`);
        await page.locator("#next").click();
        const near = await text(page, "now-near");
        if (move.nearest) {
            const shown = /touches/.test(near) ? 0 : Number(near.split(" ")[0]);
            assert.ok(Math.abs(shown - move.nearest.distance) < 2e-3, `move ${i}: ${near}, ${JSON.stringify(move.nearest)}`);
        }
    }
    assert.equal(await text(page, "now"), "Parked");
    if (turns.has("left") && turns.has("right")) assert.ok(Math.abs(turns.get("left") - turns.get("right")) > 20, [...turns].join());
    const pose = JSON.parse(await page.evaluate(() => document.documentElement.dataset.pose));
    for (const key of ["x", "y", "heading"]) assert.ok(Math.abs(pose[key] - maneuver.goal[key]) < 1e-9);
    // The path lies over the car, of which a sign marks the front; the corners' tracks are drawn where they are asked for.
    const drawn = () =>
        page.evaluate(() => {
            const [vehicle, way, ...tracks] = ["vehicle", "way .path", "trail .corner-track"].flatMap((what) => [...document.querySelectorAll(`#street .${what}`)].slice(0, what.includes(" .c") ? 9 : 1));
            return { over: !!(vehicle.compareDocumentPosition(way) & Node.DOCUMENT_POSITION_FOLLOWING), front: !!vehicle.querySelector(".ahead").getAttribute("d"), tracks: tracks.length };
        });
    assert.deepEqual(await drawn(), { over: true, front: true, tracks: 0 });
    await page.locator("#tracks").check();
    await settled(page);
    assert.deepEqual(await drawn(), { over: true, front: true, tracks: 4 });
    await page.locator("#play").click();
    await page.waitForFunction(() => / m\/s/.test(document.getElementById("now-detail").textContent) && !/ 0\.00 m\/s/.test(document.getElementById("now-detail").textContent));
    await page.locator("#play").click();
});

test("a scene file or a TPCAP case dropped on the page opens; what is none is explained", { timeout: 300_000 }, async () => {
    const page = await site.page();
    const drop = (name, content) =>
        page.evaluate(
            ([name, content]) => {
                const data = new DataTransfer();
                data.items.add(new File([content], name));
                document.querySelector("main").dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
            },
            [name, content],
        );
    const scene = {
        obstacles: [[[0, 0], [4, 0], [4, -2], [0, -2]], { polygon: [[-9, 0], [-5, 0], [-5, -2], [-9, -2]], name: "van" }, { polygon: [[-9, -2.2], [4, -2.2], [4, -3], [-9, -3]], low: true }],
        parked: { inside: [[-5, 0], [0, 0], [0, -2.2], [-5, -2.2]], heading: 0 },
        start: [1.5, 1.5, 0.05],
        region: { x_min: -10, x_max: 8, y_min: -3, y_max: 6 },
    };
    const file = join(folder, "scene.json");
    writeFileSync(file, JSON.stringify(scene));
    await drop("scene.json", JSON.stringify(scene));
    await page.waitForFunction(() => window.snugPage.inputs().scene);
    const found = await exact(page);
    assert.deepEqual(differences(found, native("park", "--car", "renault-zoe", "--scene", file)), []);
    // Short enough for a link, which brings it back.
    await page.waitForFunction(() => location.hash.includes("scene="));
    const again = await site.page({ path: await page.evaluate(() => location.hash) });
    assert.deepEqual((await inputs(again)).scene, (await inputs(page)).scene);
    // What a street has and this place has not cannot be set.
    for (const of of ["#length", "#road", "#around", "input[name=way]", "input[name=enter]", "input[name=side]"]) assert.ok(await page.locator(of).first().isHidden(), of);
    await drop("case.csv", "6,2,0,-2.5,-1,0,2,4,4,0,0,4,0,4,-2,0,-2,-9,0,-5,0,-5,-2,-9,-2");
    await page.waitForFunction(() => window.snugPage.inputs().scene?.obstacles.length === 2);
    assert.equal(await text(page, "trouble"), "");
    for (const [name, content] of [["<img src=x onerror=alert(1)>.json", "{"], ["a.csv", "1,2,<b>"], ["a.json", JSON.stringify({ ...scene, start: "here" })], ["b.json", "9".repeat(1_100_000)]]) {
        await drop(name, content);
        await page.waitForFunction(() => document.getElementById("trouble").textContent !== "");
        assert.equal(await page.evaluate(() => document.querySelectorAll("img").length), 0);
        assert.ok(await page.evaluate(() => window.snugPage.inputs().scene.obstacles.length === 2), "the last good place stays");
        await page.evaluate(() => (document.getElementById("trouble").textContent = ""));
    }
    await page.locator("#close-scene").click();
    await settled(page);
    assert.equal((await inputs(page)).scene, null);
});

test("links: the street's come back whole, the old ones open as they were, bad ones are explained", { timeout: 300_000 }, async () => {
    const page = await site.page();
    await choose(page, "kind", "angled");
    await choose(page, "enter", "forward");
    await type(page, "angle", "70");
    await type(page, "road", "5.5");
    await drag(page, "car", -30, 12);
    const one = await inputs(page);
    // The link follows a moment later.
    await page.waitForFunction((x) => Number(new URLSearchParams(location.hash.slice(1)).get("x")) === x, one.pose.x);
    const hash = await page.evaluate(() => location.hash);
    const again = await site.page({ path: hash });
    assert.deepEqual(await inputs(again), one);
    // Of another place nothing is said that was known of the last one.
    const said = await again.evaluate(
        (links) =>
            new Promise((done) => {
                const said = [];
                const { parking, map } = window.snugPage;
                const watch = () => {
                    const known = map.state()?.current || parking.proved || parking.exact;
                    const first = parking.lookedAt === parking.pose && !parking.stale; // told before the map is done
                    const last = (!known && parking.painted) || (!known && !first && (parking.bounds || parking.way));
                    said.push([document.getElementById("count").textContent, last ? "of the last" : ""]);
                    if (said.length % 12 === 0) location.hash = links.shift() ?? location.hash;
                    if (links.length === 0 && map.state()?.current) done(said);
                    else requestAnimationFrame(watch);
                };
                requestAnimationFrame(watch);
            }),
        ["#mode=street&angle=90&length=5&width=2.5", "#mode=street&length=5.4", "#mode=street&length=4.9&side=left", "#mode=street&angle=60&length=5&width=2.6", hash],
    );
    for (const [count, of] of said) {
        const [low, high] = count.split(" – ").map(Number);
        assert.ok(high === undefined || low < high, count);
        assert.equal(of, "");
    }
    await follow(again, "#car=renault-zoe&length=4.5&width=2");
    assert.equal((await inputs(again)).mode, "entry");
    assert.equal(await text(again, "count"), "18");
    for (const hostile of ["#mode=street&x=1e9&y=NaN&turn=<b>&angle=91&road=-1", "#mode=sky&way=__proto__&curb=soft&front-setback=99", "#mode=street&length=0.5&width=0.3&car-corner=3",
        "#mode=street&scene=<b>", `#mode=street&scene=${encodeURIComponent('{"obstacles":[[[0,0],[1,"<b>x</b>"],[1,1]]],"parked":{},"start":[0,0,0]}')}`]) {
        await follow(page, "#mode=street");
        await follow(page, hostile);
        const said = (await text(page, "trouble")) + (await page.locator(".error").allTextContents()).join("");
        assert.ok(said.length > 20, hostile);
        assert.equal(await page.evaluate(() => document.querySelectorAll("main b").length), 0);
        assert.equal((await inputs(page)).scene, null);
    }
});

test("what was wrong: headlines, commands, maps, slots and pictures say what is", { timeout: 300_000 }, async () => {
    // A heading from which the car gets stuck is no fit.
    const page = await site.page({ path: "#car=renault-zoe&length=4.9&width=2&heading=5" });
    assert.equal(await text(page, "verdict"), "Not from this heading");
    assert.match(await text(page, "count-note"), /The best heading takes 3/);
    assert.match(await text(page, "enter-at-note"), /gets stuck/);
    // The command does not forget it.
    assert.match(await text(page, "command"), /# heading 0\.0872\d* rad/);
    // A changed car is offered a slot that holds it.
    await page.selectOption("#car", "vw-transporter");
    await settled(page);
    assert.match(await text(page, "count-note"), /too short/);
    await page.locator("#fit-slot").click();
    await settled(page);
    assert.match(await text(page, "count"), /^\d+$/);
    // In the street, too.
    await follow(page, "#mode=street&car=renault-zoe&length=3&width=1.5");
    await page.waitForFunction(() => document.getElementById("verdict").textContent === "It does not park");
    assert.match(await text(page, "count-note"), /1\.084 m too short and 0\.271 m too narrow/);
    await page.locator("#fit-slot").click();
    await page.waitForFunction(() => document.getElementById("verdict").textContent === "It parks");
    await exact(page);
    assert.ok(await page.locator("#fit-slot").isHidden());
    // Where the map knows no way, none is said to be from the map, and none can be played.
    await follow(page, "#mode=street&car=renault-zoe&length=4.45&width=1.87");
    await page.waitForFunction(() => window.snugPage.map.state()?.current && window.snugPage.parking.bounds?.where === "free");
    await settled(page);
    const open = await page.evaluate(() => [window.snugPage.parking.way, window.snugPage.parking.proved ?? window.snugPage.answer(), document.getElementById("count-note").textContent, document.getElementById("now").textContent]);
    assert.equal(open[0], null);
    if (!open[1]) assert.match(open[2], /^(No way is known yet|Found from here)/);
    if (!open[1]) assert.equal(open[3], "Searching …");
    // All maneuvers may do better: a click tries.
    await page.evaluate(() => (location.hash = "car=renault-zoe&length=4.42&width=2"));
    await page.waitForFunction(() => !document.getElementById("try-all").hidden);
    await page.locator("#try-all").click();
    await settled(page);
    assert.equal((await inputs(page)).strategy, "fewest");
    // Front axle behind the front.
    await page.evaluate(() => (location.hash = "mode=street&car=renault-zoe"));
    await settled(page);
    await page.locator("#dimensions summary").click();
    await type(page, "car-front", "2");
    assert.match(await text(page, "car-front-error"), /must lie ahead of the front axle/);
    assert.equal((await inputs(page)).car.front, 3.427);
    await type(page, "car-front", "3.427");
    // A saved picture says what was asked, what came out, and every move.
    const { maneuver } = await exact(page);
    await settled(page);
    const [download] = await Promise.all([page.waitForEvent("download"), page.locator("#save-svg").click()]);
    const svg = readFileSync(await download.path(), "utf8");
    assert.match(svg, /snug park --car car\.json --length 4\.9/);
    assert.match(svg, new RegExp(`It parks: ${maneuver.direction_changes} direction changes?`));
    assert.equal(svg.match(/>\d+\. (forward|backward), /g).length, maneuver.moves.length);
});

test("the car by keyboard alone: everything is reached, arrows move it, full stop and comma turn it", async () => {
    const page = await site.page();
    await mapped(page); // there is something to play
    const reached = await reachedByTab(page, "save-csv");
    for (const what of ["mode", "car", "turn", "rear", "front", "curb", "far", "play", "kind", "angle", "road", "side", "way", "enter", "x", "y", "clearance", "scene-file", "show-map", "tracks", "save-csv"])
        assert.ok(reached.has(what), `${what} is not reached: ${[...reached].join(", ")}`);
    const start = await page.evaluate(() => window.snugPage.parking.pose);
    const press = async (grip, key) => {
        await page.locator(`#street [data-grip="${grip}"]`).focus();
        await page.keyboard.press(key);
        await settled(page);
        return (await inputs(page)).pose;
    };
    const near = (a, b) => assert.ok(Math.abs(a - b) < 2e-3, `${a} and ${b}`);
    near((await press("car", "ArrowRight")).x, start.x + 0.05);
    near((await press("car", "Shift+ArrowUp")).y, start.y + 0.5);
    near((await press("car", ",")).heading, Math.PI / 180);
    near((await press("turn", "Shift+ArrowDown")).heading, (-9 * Math.PI) / 180);
    await press("far", "ArrowUp");
    near((await inputs(page)).road, 6.01);
});

for (const [device, viewport, phone] of [
    ["a phone", { width: 360, height: 740 }, true],
    ["a phone held sideways", { width: 740, height: 360 }, true],
    ["a screen at 200 %", { width: 700, height: 450 }, false],
])
    test(`on ${device} picture, answer and Play are in sight, and the picture stays while numbers are typed`, async () => {
        const page = await site.page({ viewport, hasTouch: phone, isMobile: phone });
        await mapped(page);
        for (const id of ["street", "verdict", "count", "play"]) {
            const { x, y, width, height } = await page.locator(`#${id}`).boundingBox();
            assert.ok(x >= -1 && y >= 0 && x + width <= viewport.width + 1 && y + Math.min(height, 40) <= viewport.height, `${id}: ${x} ${y} ${width} ${height}`);
        }
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), viewport.width);
        await page.locator("#length").scrollIntoViewIfNeeded();
        await page.locator("#length").focus();
        const [picture, field] = [await page.locator("#street").boundingBox(), await page.locator("#length").boundingBox()];
        assert.ok(picture.y > -picture.height / 2, "the picture is out of sight");
        assert.ok(field.y >= (picture.x + picture.width > field.x ? picture.y + picture.height - 1 : 0), "the field is under the picture");
        if (phone) {
            await touched(page, "street", "car", ...[4, 8, 12, 16, 20, 24].map((by) => [-by, 0]));
            assert.ok((await inputs(page)).pose, "the car was not dragged");
        }
    });

for (const colorScheme of ["light", "dark"])
    for (const [device, viewport] of [["desktop", { width: 1400, height: 900 }], ["phone", { width: 360, height: 740 }], ["sideways", { width: 740, height: 360 }]])
        test(`axe finds nothing wrong with the street: ${device}, ${colorScheme}`, { timeout: 300_000 }, async () => {
            const page = await site.page({ viewport, colorScheme, bypassCSP: true });
            await page.evaluate(() => document.querySelectorAll("details").forEach((one) => (one.open = true)));
            assert.deepEqual(await violations(page, colorScheme), []);
            await page.evaluate(() => document.querySelectorAll("details").forEach((one) => (one.open = false)));
            await mapped(page);
            // The picture in the README is the first of them.
            if (device === "desktop" && colorScheme === "light") await page.waitForFunction(() => window.snugPage.map.state()?.finest && window.snugPage.answer());
            await settled(page);
            await screenshot(page, `page-${device}-${colorScheme}`);
        });
