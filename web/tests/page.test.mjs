// The page as a person meets it: choosing, dragging, playing, sharing, saving, typing nonsense; by mouse, keyboard, touch.
import assert from "node:assert/strict";
import { readdirSync, readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { native, root } from "./browser.mjs";
import { choose, dragged, follow, inputs, middle, reachedByTab, screenshot, settled, site, text, touched, type, violations } from "./site.mjs";

const proved = (page) => page.waitForFunction(() => document.getElementById("count-note").textContent.startsWith("Proved"));

test("each car of the catalogue has the command's answer, backward on the right and forward on the left", async () => {
    const page = await site.page({ path: "#mode=entry" });
    const names = await page.evaluate(() => [...document.querySelectorAll("#car optgroup option")].map((option) => option.value));
    assert.deepEqual(names, native("cars").map(({ name }) => name));
    for (const [i, name] of names.entries()) {
        await page.selectOption("#car", name);
        for (const [side, enter, length, width] of [["right", "backward", "6.3", "2.3"], ["left", "forward", "9", "4"]].filter((_, k) => i < 5 || k === i % 2)) {
            await choose(page, "side", side);
            await choose(page, "enter", enter);
            await type(page, "length", length);
            await type(page, "width", width);
            const expected = native("entry", "--car", name, "--length", length, "--width", width, "--side", side, "--enter", enter);
            assert.equal(await text(page, "count"), String(expected.direction_changes ?? "∅"), `${name} ${side} ${enter}`);
        }
    }
});

test("dragging the rear neighbour until the answer changes", async () => {
    const page = await site.page({ path: "#mode=entry" });
    const before = Number(await text(page, "count"));
    await dragged(page, "drawing", "rear", ...Array.from({ length: 16 }, (_, i) => [-4 * i, 0]));
    const { length } = await inputs(page);
    assert.ok(length > 5.2, `the slot is ${length} m long`);
    assert.ok(Number(await text(page, "count")) < before);
});

test("dragging over slots that are too tight ends with the exact answer", async () => {
    const page = await site.page({ path: "#car=renault-zoe&length=4.9&width=1.85" });
    assert.ok(Number(await text(page, "count")) < 60);
    const [x, y] = await middle(page, "drawing", "rear");
    await page.mouse.move(x, y);
    await page.mouse.down();
    // In and out: no way in, dozens of changes, and few.
    for (let step = 0; step <= 60; ++step) {
        await page.mouse.move(x + 60 * Math.sin(step / 6), y);
        await settled(page);
    }
    for (const at of [50, 30, 3, -3, -40]) {
        await page.mouse.move(x + at, y);
        await settled(page);
        const { length, width } = await inputs(page);
        const expected = String(native("entry", "--car", "renault-zoe", "--length", length, "--width", width).direction_changes ?? "∅");
        await page.waitForFunction((count) => document.getElementById("count").textContent === count, expected);
    }
    await page.mouse.up();
});

test("dragging the front neighbour, the curb and the heading", async () => {
    const page = await site.page({ path: "#mode=entry" });
    const start = await inputs(page);
    const drag = (what, dx, dy) => dragged(page, "drawing", what, [dx / 2, dy / 2], [dx, dy]);
    await drag("front", 30, 0);
    const longer = await inputs(page);
    assert.ok(longer.length > start.length);
    await drag("curb", 0, 20);
    const wider = await inputs(page);
    assert.ok(wider.width > longer.width);
    await drag("heading", -10, -30);
    assert.ok((await inputs(page)).heading > 0);
    assert.match(await text(page, "enter-at-note"), /^From here/);
    await page.locator("#best").click();
    await settled(page);
    assert.equal((await inputs(page)).heading, null);
    assert.equal(await page.evaluate(() => document.activeElement.id), "answer");
});

test("a maneuver played to its end stands where the command's ends", async () => {
    const page = await site.page({ path: "#car=mid-size&length=5.1&width=2.2" });
    // Quick first, which says that it is not proved, and proved a moment later.
    await page.evaluate(() => {
        const note = document.getElementById("count-note");
        window.said = [];
        new MutationObserver(() => window.said.push(note.textContent)).observe(note, { childList: true, characterData: true, subtree: true });
    });
    await type(page, "length", "5.15");
    await type(page, "length", "5.1");
    await page.waitForFunction(() => /^Proved: no heading takes fewer/.test(document.getElementById("count-note").textContent));
    const said = await page.evaluate(() => window.said);
    assert.ok(said.some((note) => note.startsWith("Not proved yet")), said.join("\n"));
    assert.equal((await page.evaluate(() => window.snugPage.answer())).proved, true);
    await page.selectOption("#speed", "10");
    await page.locator("#play").click();
    await page.waitForFunction(() => document.getElementById("now").textContent === "Parked");
    const pose = JSON.parse(await page.evaluate(() => document.documentElement.dataset.pose));
    const { goal } = native("entry", "--car", "mid-size", "--length", 5.1, "--width", 2.2).maneuver;
    for (const key of ["x", "y", "heading"]) assert.ok(Math.abs(pose[key] - goal[key]) < 1e-9, `${key}: ${pose[key]} and ${goal[key]}`);
    // Step by step: back at the first move, then on over all ten.
    await page.locator("#moves li button").first().click();
    assert.match(await text(page, "now"), /^1 of 10: backward, full left/);
    for (let i = 0; i < 10; ++i) await page.locator("#next").click();
    assert.equal(await text(page, "now"), "Parked");
    await page.locator("#scrub").fill("500");
    assert.match(await text(page, "now"), / of 10: /);
});

test("the fewest over all maneuvers are proved in a worker, and abandoned when the slot changes", async () => {
    const page = await site.page({ path: "#car=renault-zoe&length=5.2&width=1.9" });
    assert.equal(await text(page, "count"), "3");
    await choose(page, "strategy", "fewest");
    await proved(page);
    assert.equal(await text(page, "count"), "2");
    await type(page, "length", "4.55");
    await type(page, "length", "4.8");
    await type(page, "width", "1.84");
    await proved(page);
    assert.equal(await text(page, "count"), "8");
    await page.locator("#save-csv").click();
    assert.match(await text(page, "shared"), /take JSON/);
});

test("the bounds are shown as they close, and the page stays alive meanwhile", async () => {
    const page = await site.page({ path: "#car=renault-zoe&length=4.42&width=2&strategy=fewest" });
    await page.waitForFunction(() => / – /.test(document.getElementById("count").textContent));
    const [low, high] = (await text(page, "count")).split(" – ").map(Number);
    assert.ok(low > 0 && low < high, `${low} to ${high}`);
    await choose(page, "strategy", "max-steer");
    assert.equal(await text(page, "count"), "∅"); // with full steering there is no way in
});

test("the maps say what the answer says, and their point is the slot", async () => {
    const page = await site.page({ path: "#car=mid-size&length=5.4&width=2.2" });
    await page.locator("#maps-title").scrollIntoViewIfNeeded();
    await page.locator("#map-max-steer .point").scrollIntoViewIfNeeded();
    await page.waitForSelector("#map-max-steer[data-done]");
    const map = await page.locator("#map-max-steer canvas").boundingBox();
    for (const [across, up] of [[0.83, 0.6], [0.6, 0.41], [0.35, 0.8]]) {
        // The middle of a cell, as near as the screen allows.
        await page.mouse.click(map.x + map.width * across, map.y + map.height * (1 - up));
        await settled(page);
        const { length, width } = await inputs(page);
        assert.ok(Math.abs(length - 4.7 - across * 1.92) < 0.02 && Math.abs(width - 1.8 - up * 0.96) < 0.02, `${length} x ${width}`);
        const cell = { length: 4.7 + ((Math.floor(((length - 4.7) / 1.92) * 48) + 0.5) / 48) * 1.92, width: 1.8 + ((Math.floor(((width - 1.8) / 0.96) * 32) + 0.5) / 32) * 0.96 };
        const expected = await page.evaluate((slot) => window.snugPage.snug.entry("mid-size", slot).direction_changes, cell);
        assert.match(await page.locator("#map-max-steer .point").getAttribute("aria-label"), new RegExp(`: ${expected} direction changes?\\b`));
    }
    // How far the long one is; and more than are counted is another colour than impossible, which is left open to the hatching.
    await page.waitForFunction(() => /\d %/.test(document.querySelector("#map-fewest .state").textContent));
    await page.waitForSelector("#map-fewest[data-done]");
    const drawn = (id) =>
        page.evaluate((id) => {
            const { data } = document.querySelector(`#${id} canvas`).getContext("2d").getImageData(0, 0, 48, 32);
            const cells = Array.from({ length: 48 * 32 }, (_, i) => data.subarray(4 * i, 4 * i + 4).join());
            return { open: cells.some((cell) => cell.endsWith(",0")), more: cells.includes("141,135,145,255") };
        }, id);
    assert.deepEqual(await drawn("map-max-steer"), { open: true, more: false });
    assert.deepEqual(await drawn("map-fewest"), { open: false, more: true });
    assert.match(await text(page, "legend"), /more than 12, of all maneuvers.*impossible/);
});

test("a link brings everything back", async () => {
    const page = await site.page({ path: "#mode=entry" });
    await page.selectOption("#car", "vw-transporter");
    await choose(page, "side", "left");
    await type(page, "length", "6.4");
    await type(page, "width", "2,35");
    await type(page, "clearance", "0.02");
    await type(page, "heading", "24.5");
    await page.locator("#dimensions summary").click();
    await type(page, "car-wheelbase", "3.3");
    await page.waitForFunction(() => location.hash.includes("wheelbase=3.3"));
    const hash = new URL(page.url()).hash;
    const [one, count] = [await inputs(page), await text(page, "count")];
    const again = await site.page({ path: hash });
    const two = await inputs(again);
    const { car, ...rest } = one;
    const { car: sameCar, ...sameRest } = two;
    for (const key of Object.keys(rest))
        if (typeof rest[key] === "number") assert.ok(Math.abs(rest[key] - sameRest[key]) < 1e-9, key);
        else assert.equal(sameRest[key], rest[key], key);
    for (const key of Object.keys(car)) assert.ok(Math.abs(car[key] - sameCar[key]) < 1e-8, key);
    assert.equal(await text(again, "count"), count);
});

test("what is downloaded can be read", async () => {
    const page = await site.page({ path: "#car=renault-zoe&length=4.5&width=2" });
    const saved = async (what) => {
        const [download] = await Promise.all([page.waitForEvent("download"), page.locator(`#save-${what}`).click()]);
        assert.equal(download.suggestedFilename(), `snug-renault-zoe-4.5x2.${what}`);
        return readFileSync(await download.path());
    };
    const json = JSON.parse(String(await saved("json")));
    assert.equal(json.schema, 1);
    assert.equal(json.direction_changes, 18);
    const [head, ...rows] = String(await saved("csv")).trim().split("\n");
    assert.equal(head, "heading_min,heading_max,direction_changes,subrange");
    assert.equal(rows.length, json.entry_ranges.length);
    assert.equal(Number(rows[0].split(",")[0]), json.entry_ranges[0].heading_min);
    const svg = String(await saved("svg"));
    const parsed = await page.evaluate((source) => {
        const document = new DOMParser().parseFromString(source, "image/svg+xml");
        return { root: document.documentElement.localName, paths: document.querySelectorAll("path[fill]").length };
    }, svg);
    assert.equal(parsed.root, "svg");
    assert.ok(parsed.paths > 10);
    const png = await saved("png");
    assert.equal(png.subarray(1, 4).toString(), "PNG");
    assert.ok(png.length > 20_000, `the picture has ${png.length} bytes`);
    assert.match(await text(page, "command"), /^snug entry --car renault-zoe --length 4.5 --width 2$/);
});

test("bad numbers are explained next to their field, and the last good picture stays", async () => {
    const page = await site.page({ path: "#mode=entry" });
    const count = await text(page, "count");
    const street = await page.locator("#drawing .street").innerHTML();
    for (const nonsense of ["", "4.", "-", "abc", "1e999", "NaN", "0", "-3", "1e6", "4,5,6", "<b>5</b>", "💥", "4.5 kg", "9".repeat(40)]) {
        await type(page, "length", "4.9");
        await type(page, "length", nonsense);
        if (nonsense === "4.") continue; // half-typed, and a number: four metres
        assert.match(await text(page, "length-error"), /slot’s length/, nonsense);
        assert.equal(await page.locator("#length").getAttribute("aria-invalid"), "true");
        assert.equal(await text(page, "count"), count, nonsense);
        assert.equal(await page.locator("#drawing .street").innerHTML(), street, nonsense);
    }
    // The sentence stays when something else changes, and goes when the slot does.
    await type(page, "width", "2.1");
    assert.notEqual(await text(page, "length-error"), "");
    await page.locator('#drawing [data-grip="rear"]').press("ArrowRight");
    await settled(page);
    assert.equal(await text(page, "length-error"), "");
    await type(page, "length", "5.5");
    // The smallest and the largest numbers the page takes.
    await page.locator("#dimensions summary").click();
    for (const [field, values] of Object.entries({ length: ["0.5", "40"], width: ["0.3", "10"], "car-width": ["0.3", "6"], "car-rear": ["0.05", "12"],
        "car-wheelbase": ["0.3"], "car-front": ["0.3", "25"], "car-steer": ["5", "80"], clearance: ["1", "0"], heading: ["0", "90"] }))
        for (const value of values) {
            await type(page, field, value);
            assert.equal(await text(page, `${field}-error`), "", `${field} ${value}`);
            assert.match(await text(page, "count"), /^(\d+|∅)$/);
        }
});

test("random inputs never stop the page or break it", async () => {
    const page = await site.page({ path: "#mode=entry" });
    const counts = await page.evaluate(async () => {
        let seed = 66;
        const next = () => ((seed = (seed * 1103515245 + 12345) % 2147483648), seed / 2147483648);
        const counts = [];
        for (let i = 0; i < 60; ++i) {
            const [a, b, c, d] = [next(), next(), next(), next()];
            location.hash = `car-width=${0.5 + 2 * a}&car-front=${1 + 6 * b}&car-rear=${0.1 + 2 * c}&car-wheelbase=${0.6 + 4 * b * d}&car-steer=${6 + 70 * d}&length=${1 + 11 * c}&width=${0.4 + 5 * a}&side=${a < 0.5 ? "left" : "right"}&enter=${b < 0.5 ? "forward" : "backward"}&clearance=${d < 0.3 ? d : 0}`;
            await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
            counts.push(document.getElementById("count").textContent);
        }
        return counts;
    });
    for (const count of counts) assert.match(count, /^(\d+|∅)$/);
});

test("hostile and outdated links are explained and put nothing into the page", async () => {
    const hostile = [
        "#car=<img src=x onerror=alert(1)>&length=<script>alert(1)</script>",
        "#car=%3Cimg%20src%3Dx%20onerror%3Dalert(1)%3E&width=javascript:alert(1)",
        "#length=1e308&width=-0&side=up&strategy=__proto__&enter=constructor",
        "#__proto__[x]=1&constructor=2&car=toString",
        `#${"length=5&".repeat(5000)}`,
        "#%E0%A4%A&length=%",
    ];
    const page = await site.page({ path: hostile[0] });
    page.on("dialog", () => assert.fail("a dialog"));
    for (const hash of hostile) {
        await follow(page, hash);
        const inside = await page.evaluate(() => [document.querySelectorAll("img, main script").length, document.body.innerHTML.includes("onerror")]);
        assert.deepEqual(inside, [0, false], hash.slice(0, 60));
        assert.match(await text(page, "count"), /^\d+$/);
    }
    await follow(page, "#car=trabant&length=5.5&width=wide");
    assert.match(await text(page, "trouble"), /not in the catalogue/);
    assert.match(await text(page, "width-error"), /^In the link: The slot’s width must be a number/);
    assert.equal((await inputs(page)).length, 5.5);
});

test("without WebAssembly there is a sentence", async () => {
    const page = await site.page({ ready: false, path: "story.html" });
    await page.addInitScript(() => delete window.WebAssembly);
    await page.goto(site.address);
    await page.locator("#trouble").waitFor({ state: "visible" });
    assert.match(await text(page, "trouble"), /needs a browser with WebAssembly/);
    assert.equal(await page.locator("main > :visible").count(), 1, "nothing that would not work");
});

test("the keyboard alone reaches and changes everything", async () => {
    const page = await site.page({ path: "#mode=entry" });
    const reached = await reachedByTab(page, "save-csv");
    for (const what of ["rear", "front", "curb", "heading", "play", "previous", "next", "scrub", "speed", "car", "length", "width", "side", "enter",
        "strategy", "clearance", "swept", "point", "copy-link", "copy-command", "save-svg", "save-png", "save-json", "save-csv"])
        assert.ok(reached.has(what), `${what} is not reached: ${[...reached].join(", ")}`);
    const press = async (selector, key) => {
        await page.locator(selector).first().focus();
        await page.keyboard.press(key);
        await settled(page);
        return inputs(page);
    };
    const { length, width } = await inputs(page);
    const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-9, `${a} and ${b}`);
    near((await press('#drawing [data-grip="rear"]', "ArrowRight")).length, length + 0.01);
    near((await press('#drawing [data-grip="front"]', "Shift+ArrowUp")).length, length + 0.11);
    near((await press('#drawing [data-grip="curb"]', "Alt+ArrowUp")).width, width + 0.001);
    assert.ok((await press('#drawing [data-grip="heading"]', "ArrowUp")).heading > 0);
    near((await press(".point", "ArrowLeft")).length, length + 0.1);
    near((await press("#length", "ArrowUp")).length, length + 0.11);
});

test("on a phone the answer is on the first screen, and a long list of moves shows that it goes on", async () => {
    const page = await site.page({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true, path: "#car=renault-zoe&length=4.5&width=2" });
    for (const id of ["verdict", "count", "enter-at", "shorter"]) {
        const { y, height } = await page.locator(`#${id}`).boundingBox();
        assert.ok(y + height < 740, `${id} is below the screen`);
    }
    assert.equal(await text(page, "moves-count"), "19 moves");
    assert.match(await page.locator("#moves li").first().innerText(), /backward, full left\s+33\.0°\s+0\.080 m\s+rear-left corner meets rear neighbour/);
    const more = () => page.locator("#moves[data-more]").count();
    assert.equal(await more(), 1);
    // The move under way is in sight.
    await page.locator("#scrub").fill("1000");
    await page.waitForFunction(() => !document.querySelector("#moves[data-more]"));
    await page.locator("#scrub").fill("0");
    await page.waitForFunction(() => document.querySelector("#moves[data-more]"));
    assert.equal(await page.evaluate(() => document.getElementById("moves").scrollTop), 0);
});

test("touch drags the curb on a phone, and nothing is wider than its screen", async () => {
    const page = await site.page({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true, path: "#mode=entry" });
    const { width } = await inputs(page);
    await touched(page, "drawing", "curb", ...[4, 8, 12, 16, 20, 24].map((by) => [0, by]));
    assert.ok((await inputs(page)).width > width);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
    const hidden = await page.evaluate(() =>
        [...document.querySelectorAll("[data-grip] .knob")].filter((knob) => {
            const { left, right } = knob.getBoundingClientRect();
            return left < 0 || right > 360;
        }).length,
    );
    assert.equal(hidden, 0, "handles outside the screen");
});

for (const colorScheme of ["light", "dark"])
    for (const [device, viewport] of [["desktop", { width: 1400, height: 900 }], ["phone", { width: 360, height: 740 }]])
        test(`axe finds nothing wrong: the entry position and the story, ${device}, ${colorScheme}`, async () => {
            const page = await site.page({ path: "#car=renault-zoe&length=4.5&width=2", viewport, colorScheme, bypassCSP: true });
            assert.deepEqual(await violations(page, colorScheme), []);
            await page.evaluate(() => document.querySelectorAll("#moves li button")[9].click());
            await page.evaluate(() => scrollTo(0, 0));
            await screenshot(page, `entry-${device}-${colorScheme}`, { fullPage: device === "phone" });
            await page.goto(`${site.address}story.html`);
            assert.deepEqual(await violations(page, colorScheme), []);
            await screenshot(page, `story-${device}-${colorScheme}`, { fullPage: true });
        });

test("the first load is at most 350 KB compressed", async () => {
    // All but the story, which is another page.
    const files = (folder) =>
        readdirSync(folder).flatMap((name) => (statSync(join(folder, name)).isDirectory() ? files(join(folder, name)) : [join(folder, name)]));
    const size = files(join(root, "dist"))
        .filter((file) => !file.endsWith("story.html"))
        .reduce((sum, file) => sum + gzipSync(readFileSync(file), { level: 9 }).length, 0);
    assert.ok(size < 350_000, `${size} bytes`);
});
