// All tests of the page, with one browser: `npm test`. Each file can be run alone, too.
import "./page.test.mjs";
import "./street.test.mjs";
import "./same_answers.test.mjs";
import "./package.test.mjs";
