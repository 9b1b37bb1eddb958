using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>A file whose content is read at most once, and only if a pattern needs it.</summary>
/// <param name="name">Its name.</param>
/// <param name="bytes">Its content.</param>
/// <param name="format">Its format; null for a probing log.</param>
internal sealed class LookInside(string name, ReadOnlyMemory<byte> bytes, MeasurementFormat? format)
{
    private MeasurementFile? _table;
    private IReadOnlyList<HeaderField>? _fields;

    public string Name => name;

    /// <summary>The values of a header field; none if the file does not have it.</summary>
    /// <exception cref="InputException">The file cannot be read.</exception>
    public IReadOnlyList<string> HeaderField(string field)
    {
        _fields ??= format is null ? ProbingLogHeader.Read(bytes.Span) : Table().HeaderFields;
        return [.. _fields.Where(f => string.Equals(f.Name, field, StringComparison.OrdinalIgnoreCase)).Select(f => f.Value)];
    }

    /// <summary>The values of a column; none if the file does not have it.</summary>
    /// <exception cref="InputException">The file cannot be read.</exception>
    public IReadOnlyList<string> Column(string column) => format is null ? [] : Table().ColumnTexts(column) ?? [];

    private MeasurementFile Table() => _table ??= MeasurementReader.Read(bytes, name, format!);
}
