"""Conversion of tables for pandas, and to record batches of pyarrow, which exports the Arrow PyCapsule interface."""

from typing import Any

from gaitcam._missing import needed


def batch(table: Any) -> Any:
    """Converts a table to a ``pyarrow.RecordBatch``: numbers without copies, NaN as null, words as a dictionary array."""
    pyarrow = needed("pyarrow", "gaitcam[arrow]")
    arrays, fields = [], []
    for name in table.column_names:
        if (coded := table._coded(name)) is None:
            array = pyarrow.array(table[name], from_pandas=True)
        else:
            codes, words = coded
            indices = pyarrow.array(codes, mask=codes < 0)
            array = pyarrow.DictionaryArray.from_arrays(indices, pyarrow.array(words, pyarrow.utf8()))
        is_row_number = pyarrow.types.is_uint64(array.type)
        unit = table.units.get(name)
        metadata = {"unit": unit} if unit else None
        arrays.append(array)
        fields.append(pyarrow.field(name, array.type, nullable=not is_row_number, metadata=metadata))
    schema = pyarrow.schema(fields, metadata=table.metadata or None)
    return pyarrow.RecordBatch.from_arrays(arrays, schema=schema)


def frame(table: Any) -> Any:
    """Converts a table to a ``pandas.DataFrame``. Words are categories; a missing word is NaN."""
    pandas = needed("pandas", "pandas")

    def column(name: str) -> Any:
        coded = table._coded(name)
        return table[name] if coded is None else pandas.Categorical.from_codes(coded[0], coded[1])

    return pandas.DataFrame({name: column(name) for name in table.column_names}, copy=False)
