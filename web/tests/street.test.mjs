// The street as a person meets it: the car is dragged, turned, let go; what the page says is what the command says.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, before, test } from "node:test";
import { differences, native, open, random, root } from "./browser.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const folder = mkdtempSync(join(tmpdir(), "snug-street-"));
let site;
before(async () => {
    site = await open();
});
after(async () => {
    await site?.close();
    rmSync(folder, { recursive: true });
});
afterEach(() => assert.deepEqual(site.troubles.splice(0), [], "errors on the console or requests to elsewhere"));

const text = (page, id) => page.locator(`#${id}`).textContent();
const inputs = (page) => page.evaluate(() => window.snugPage.inputs());
const settled = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const choose = async (page, name, value) => {
    await page.locator(`input[name=${name}][value=${value}]`).check({ force: true });
    await settled(page);
};
const type = async (page, field, value) => {
    await page.locator(`#${field}`).fill(value);
    await settled(page);
};
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
const middle = async (page, grip) => {
    const { x, y, width, height } = await page.locator(`#street [data-grip="${grip}"] ${grip === "car" ? ".reach" : ".knob"}`).boundingBox();
    return [x + width / 2, y + height / 2];
};
const drag = async (page, grip, dx, dy) => {
    const [x, y] = await middle(page, grip);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + dx / 2, y + dy / 2);
    await page.mouse.move(x + dx, y + dy);
    await settled(page);
    await page.mouse.up();
    await settled(page);
};

test("the car dragged to ten poses: the map bounds the command's count, and the exact answer is the command's, bit for bit", { timeout: 900_000 }, async () => {
    const page = await site.page();
    await mapped(page);
    const next = random(17);
    let free = 0;
    for (let i = 0; i < 40 && free < 10; ++i) {
        const [x, y] = await middle(page, "car");
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
        assert.equal(await text(page, "count"), found.proved ? String(found.direction_changes) : `≤ ${found.direction_changes}`);
        assert.ok(bounds.lower_bound <= found.direction_changes);
        if (bounds.direction_changes !== undefined) assert.ok(bounds.direction_changes >= found.lower_bound);
    }
    assert.equal(free, 10);
    await page.context().close();
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
        if (way === "out") await drag(page, "car", 3, 0); // `snug leave` is told where the car stands
        await sameAsCommand(page, `${kind} ${enter} ${side} ${way}`);
    }
    await page.context().close();
});

test("unequal neighbours, a low curb, an open road and clearance have the command's answer", { timeout: 900_000 }, async () => {
    const page = await site.page({ path: "#mode=street&front-setback=0.3&rear-setback=0.1&curb=low&road=open&clearance=0.05&length=5.2" });
    assert.equal((await inputs(page)).road, null);
    const found = await sameAsCommand(page, "setbacks");
    assert.equal(found.slot.front_setback, 0.3);
    assert.equal(found.slot.curb, "low");
    await page.context().close();
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
    await page.context().close();
});

test("dragging neighbours, curb and far side changes the place, and the car stays where it is", async () => {
    const page = await site.page();
    await mapped(page);
    const start = await inputs(page);
    await drag(page, "rear", -40, 0);
    const longer = await inputs(page);
    assert.ok(longer.length > start.length + 0.3);
    await drag(page, "car", -20, -10);
    const [x, y] = await middle(page, "car");
    await drag(page, "front", 30, 0);
    const front = await inputs(page);
    assert.ok(front.length > longer.length && front.pose.x < (await page.evaluate(() => 1e9)));
    await drag(page, "curb", 0, 20);
    assert.ok((await inputs(page)).width > front.width);
    await drag(page, "far", 0, 30);
    assert.ok((await inputs(page)).road < start.road);
    assert.ok(Math.hypot(x, y) > 0);
    await mapped(page);
    await page.context().close();
});
