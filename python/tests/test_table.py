"""Tables: numpy, pandas, polars and pyarrow read them without copies."""

import gc
import pickle

import numpy as np
import pytest

import gaitcam

NUMBERS = np.array([1.5, np.nan, -np.inf, 0.1])
WORDS = ["a", None, "b", "a"]


@pytest.fixture
def table():
    columns = {"row": [7, 8, 9, 10], "stroke_m": NUMBERS, "verdict": WORDS}
    return gaitcam.Table(columns, [("plan", "x")])


def test_columns_are_read_only_views_that_outlive_the_table(table):
    view = table["stroke_m"]
    assert np.shares_memory(view, table["stroke_m"])
    assert not view.flags.writeable
    with pytest.raises(ValueError):
        view[0] = 2
    del table
    gc.collect()
    assert np.array_equal(view, NUMBERS, equal_nan=True)


def test_columns_come_back_as_they_went(table):
    assert table["verdict"] == WORDS
    assert table["row"].dtype == np.uint64 and list(table["row"]) == [7, 8, 9, 10]
    assert (len(table), table.num_rows, table.units) == (4, 4, {"stroke_m": "m"})
    assert "verdict" in table and "verdct" not in table
    with pytest.raises(KeyError, match="verdict"):
        table["verdct"]
    again = pickle.loads(pickle.dumps(table))
    assert again.column_names == table.column_names and again.metadata == {"plan": "x"}
    assert np.array_equal(again["stroke_m"], NUMBERS, equal_nan=True) and again["verdict"] == WORDS


def test_pyarrow_reads_numbers_without_a_copy(table):
    pa = pytest.importorskip("pyarrow")
    for read in (pa.table(table), pa.record_batch(table)):
        column = read.column("stroke_m")
        chunk = column.chunk(0) if hasattr(column, "chunk") else column
        assert chunk.buffers()[1].address == table["stroke_m"].ctypes.data
        assert chunk.null_count == 1 and chunk.to_pylist() == [1.5, None, -np.inf, 0.1]
        assert read.column("verdict").to_pylist() == WORDS
        assert pa.types.is_dictionary(read.schema.field("verdict").type)
        assert read.schema.field("stroke_m").metadata == {b"unit": b"m"}
        assert read.schema.metadata == {b"plan": b"x"}
        read.validate(full=True)
    assert pa.schema(table).names == table.column_names


def test_what_arrow_holds_outlives_the_table(table):
    pa = pytest.importorskip("pyarrow")
    held = pa.table(table)
    del table
    gc.collect()
    assert held.column("stroke_m").to_pylist() == [1.5, None, -np.inf, 0.1]
    parts = held.column("verdict").chunk(0).dictionary
    del held
    gc.collect()
    assert parts.to_pylist() == ["a", "b"]


def test_polars_and_pandas_read_it(table):
    pl, pd = pytest.importorskip("polars"), pytest.importorskip("pandas")
    frame = pl.DataFrame(table)
    assert frame["verdict"].to_list() == WORDS and frame["stroke_m"].to_list() == [1.5, None, -np.inf, 0.1]
    if hasattr(pd.DataFrame, "from_arrow"):
        frame = pd.DataFrame.from_arrow(table)
        assert np.array_equal(frame["stroke_m"], NUMBERS, equal_nan=True)
        assert frame["verdict"].astype(object).where(frame["verdict"].notna(), None).tolist() == WORDS
    frame = table.to_pandas()
    assert list(frame.columns) == table.column_names and np.array_equal(frame["stroke_m"], NUMBERS, equal_nan=True)
    assert frame["verdict"].astype(object).where(frame["verdict"].notna(), None).tolist() == WORDS


def test_an_empty_table_is_a_table_everywhere():
    pa = pytest.importorskip("pyarrow")
    empty = gaitcam.Table({"x_m": np.zeros(0), "word": []})
    assert pa.table(empty).num_rows == 0 and pickle.loads(pickle.dumps(empty)).column_names == ["x_m", "word"]
    assert pa.table(gaitcam.Table({})).num_columns == 0


def test_columns_that_do_not_fit_are_named():
    with pytest.raises(gaitcam.InputError) as fault:
        gaitcam.Table({"a": [1.0, 2.0], "b": [1.0]})
    assert fault.value.key == "b"
    with pytest.raises(TypeError, match="b"):
        gaitcam.Table({"b": [object()]})
