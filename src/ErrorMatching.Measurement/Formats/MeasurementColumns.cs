namespace ErrorMatching.Measurement;

/// <summary>Which columns hold what. Each way of arranging points in a file is a folder beside this one: its columns, its rows, and its usual format as data.</summary>
/// <remarks>A new way derives from this and is registered in <see cref="FormatJson"/>.</remarks>
public abstract record MeasurementColumns
{
    private protected MeasurementColumns()
    {
    }

    /// <summary>How a file with these columns arranges its points, as a format's <c>kind</c> names it.</summary>
    public abstract string Kind { get; }

    /// <summary>The columns that a file must have.</summary>
    internal abstract IEnumerable<ColumnSelector> Required { get; }

    /// <summary>The names of the columns in a description, and whether each may be absent.</summary>
    internal abstract IReadOnlyList<(string Name, bool IsOptional)> Members { get; }

    /// <summary>
    /// True if the table starts with a header line: if any column is given by name.
    /// Positions need none; one that is there is skipped by <see cref="MeasurementFormat.SkipLines"/>.
    /// </summary>
    internal bool NeedHeader => Required.Any(c => c.Name is not null);

    /// <summary>The same columns with another one of <see cref="Members"/>; null only for an optional one.</summary>
    internal abstract MeasurementColumns With(string member, ColumnSelector? column);

    /// <summary>The points of a table, those of the drawing if it has them, and where the labels are.</summary>
    internal abstract (IReadOnlyList<LabelledPoint> Points, IReadOnlyList<LabelledPoint> Nominals, Place Labels) Read(Table table, MeasurementFormat format);
}
