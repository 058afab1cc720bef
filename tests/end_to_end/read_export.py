"""Reads what `palpate export` wrote, as a script of a study would, and writes what the round trip needs:
    read_export.py EXPORTED OUT          as csv: cells.csv and differences.csv, as read_export.R
    read_export.py EXPORTED OUT --bids   the same from a BIDS data set, its force files read as well
"""
import json
import pathlib
import sys

import pandas

exported, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])


def from_csv():
    codebook = pandas.read_csv(exported / "codebook.csv")
    for name in ("trials", "intervals", "exposures", "events"):
        data = pandas.read_csv(exported / f"{name}.csv")
        described = codebook[codebook.table == name]
        assert list(data.columns) == list(described.column), name
        for _, column in described.iterrows():
            if len(data) and "number" in column.kind:
                assert pandas.api.types.is_numeric_dtype(data[column.column]), column.column
            if not column.may_be_missing:
                assert not data[column.column].isna().any(), column.column
    return pandas.read_csv(exported / "trials.csv")


def check_force(sidecar_file):
    sidecar = json.loads(sidecar_file.read_text())
    force = pandas.read_csv(sidecar_file.with_suffix(".tsv.gz"), sep="\t", names=sidecar["Columns"])
    assert all(pandas.api.types.is_numeric_dtype(kind) for kind in force.dtypes)
    intervals = pandas.read_csv(str(sidecar_file).replace("_recording-force_physio.json", "_acq-intervals_beh.tsv"),
                                sep="\t")
    counted = force[force.counted == 1]
    peak = (counted.force_x_n**2 + counted.force_y_n**2 + counted.force_z_n**2) ** 0.5
    peaks = peak.groupby([counted.trial, counted.interval]).max()
    said = intervals.set_index(["trial", "interval"]).peak_force_n
    assert (abs(peaks - said) <= 1e-6 * said).all()  # both were single precision


def from_bids():
    participants = pandas.read_csv(exported / "participants.tsv", sep="\t")
    tables = [pandas.read_csv(file, sep="\t")
              for file in sorted(exported.glob("sub-*/ses-*/beh/*_beh.tsv")) if "_acq-" not in file.name]
    for file in exported.glob("sub-*/ses-*/beh/*_recording-force_physio.json"):
        check_force(file)
    trials = pandas.concat(tables)
    assert set(trials.participant_id) == set(participants.participant_id)
    return trials


trials = from_bids() if "--bids" in sys.argv else from_csv()
counted = trials[trials.voided == 0]
cells = counted.groupby("contact_model").correct.agg(["sum", "count"])
cells.columns = ["correct", "trials"]
cells.to_csv(out / "cells.csv", index_label="cell")
share = counted.groupby(["participant_id", "contact_model"]).correct.mean().unstack()
(share.iloc[:, 0] - share.iloc[:, -1]).to_csv(out / "differences.csv", index=False, header=["difference"])
