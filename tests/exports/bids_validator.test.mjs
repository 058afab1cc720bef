import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";

const palpate = process.env.PALPATE;
const validator = join(process.env.PALPATE_EXPORTS_FOLDER, "node_modules/bids-validator/bin/bids-validator");
const protocol = join(dirname(fileURLToPath(import.meta.url)), "../../protocols/kuroda2003.toml");
const folder = mkdtempSync(join(tmpdir(), "palpate-bids-"));
const exported = join(folder, "bids");

before(() => {
  const study = join(folder, "study.db");
  execFileSync(palpate, ["simulate", protocol, "--study", study, "--examinees", "3", "--seed", "1"]);
  execFileSync(palpate, ["export", study, "--as", "bids", "--out", exported, "--author", "A. Author",
    "--author", "B. Author"]);
});
after(() => rmSync(folder, { recursive: true }));

function validate() {
  const { status, stdout } = spawnSync(process.execPath, [validator, exported, "--json"], { encoding: "utf8" });
  return { status, ...JSON.parse(stdout) };
}

test("the data set has neither errors nor warnings", () => {
  const { status, issues, summary } = validate();
  assert.deepEqual(issues.errors, []);
  assert.deepEqual(issues.warnings, []);
  assert.equal(status, 0);
  assert.deepEqual(summary.subjects.sort(), ["S01", "S02", "S03"]);
  assert.deepEqual(summary.tasks, ["kuroda2003"]);
});

test("the validator would have found an error", () => {
  const file = join(exported, "participants.tsv");
  const whole = readFileSync(file, "utf8");
  writeFileSync(file, whole.replace("sub-S02", "S02"));
  const { status, issues } = validate();
  writeFileSync(file, whole);
  assert.notEqual(status, 0);
  assert.notDeepEqual(issues.errors, []);
});
