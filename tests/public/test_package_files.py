"""What a published package has: files that agree with each other and with the code."""

import re
import tomllib
from pathlib import Path

import pytest
import yaml

import bondem
from bondem.io import commit

ROOT = Path(__file__).parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def test_the_version_follows_from_git_and_is_declared_nowhere_else():
    assert PROJECT["dynamic"] == ["version"]
    assert re.match(r"\d+\.\d+", bondem.__version__)
    citation = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert "version" not in citation
    assert citation["license"] == PROJECT["license"]


def test_an_installed_package_knows_its_commit_from_its_version(monkeypatch, tmp_path):
    monkeypatch.setattr(commit, "_ROOT", tmp_path)
    monkeypatch.setattr(commit, "__version__", "0.1.0.dev5+g96d079a5f.d20261128")
    assert commit.commit.__wrapped__() == "96d079a5f"
    monkeypatch.setattr(commit, "__version__", "0.1.0")  # its tag says which
    assert commit.commit.__wrapped__() is None


def test_the_conda_recipe_needs_what_the_package_needs():
    recipe = (ROOT / "conda" / "meta.yaml").read_text(encoding="utf-8")
    found = re.findall(r"^    - (\w[\w-]* >=\S+)$", recipe, re.MULTILINE)
    needed = {one.replace("-base", "").replace(" ", "") for one in found}
    assert set(PROJECT["dependencies"]) <= needed
    build, steps = recipe.partition("run:")[0], ("download", "ziglang")
    assert "BONDEM_CXX" in build
    assert not [line for line in build.splitlines() for word in steps if word in line and not line.startswith("#")]
    assert "--no-build-isolation" in build  # conda-forge builds without a network


@pytest.mark.parametrize("name", ["tests", "wheels", "docs"])
def test_workflows_can_be_read(name):
    flow = yaml.safe_load((ROOT / ".github" / "workflows" / f"{name}.yml").read_text(encoding="utf-8"))
    assert flow["permissions"] == {"contents": "read"}  # what is not said is not allowed
    for job in flow["jobs"].values():
        assert job.get("timeout-minutes") or "environment" in job
        assert job["steps"]


def test_templates_ask_for_version_and_code():
    forms = {path.stem: yaml.safe_load(path.read_text(encoding="utf-8"))
             for path in (ROOT / ".github" / "ISSUE_TEMPLATE").glob("*.yml")}  # fmt: skip
    assert {"bug", "question", "config"} == set(forms)
    asked = {field["id"]: field.get("validations", {}) for field in forms["bug"]["body"]}
    assert all(asked[one].get("required") for one in ("what", "how", "version", "machine"))
    assert ".ci/run" in (ROOT / ".github" / "pull_request_template.md").read_text(encoding="utf-8")


def test_classifiers_say_where_bondem_runs_and_binder_has_what_notebooks_need():
    found = " ".join(PROJECT["classifiers"])
    assert all(one in found for one in ("Linux", "MacOS", "Windows", "Python :: 3.11", "Typing :: Typed"))
    assert "-e ." in (ROOT / ".binder" / "requirements.txt").read_text(encoding="utf-8").splitlines()
    assert "notebooks" in (ROOT / ".binder" / "postBuild").read_text(encoding="utf-8")
    assert ":latest" not in (ROOT / "Containerfile").read_text(encoding="utf-8")


def test_citations_of_the_paper_are_in_its_bibliography():
    text = (ROOT / "paper.md").read_text(encoding="utf-8")
    known = re.findall(r"^@\w+\{(\w+),", (ROOT / "paper.bib").read_text(encoding="utf-8"), re.MULTILINE)
    assert set(re.findall(r"@(\w+\d{4})", text)) == set(known)
    assert 250 <= len(text.split()) <= 1000  # what JOSS asks for


def test_policies_are_there():
    papers = ("CODE_OF_CONDUCT.md", "SECURITY.md", "LICENSE", "CONTRIBUTING.md", "docs/deprecation.md")
    for name in (*papers, ".pre-commit-config.yaml"):
        assert (ROOT / name).stat().st_size > 500
