namespace ErrorMatching.Measurement;

/// <summary>Assigns the columns of a file. Each kind of point arrangement is a subfolder with its columns, what reads its rows, and a
/// default format.</summary>
/// <remarks>A new kind derives from this class and is registered in <see cref="FormatReader"/>.</remarks>
public abstract record MeasurementColumns
{
    private protected MeasurementColumns()
    {
    }

    /// <summary>The kind of point arrangement, as in a format's <c>kind</c>.</summary>
    public abstract string Kind { get; }

    internal abstract IEnumerable<ColumnSelector> Required { get; }

    /// <summary>The names of the columns in a description, and whether each is optional.</summary>
    internal abstract IReadOnlyList<(string Name, bool IsOptional)> Members { get; }

    /// <summary>True if the table starts with a header line, that is, if any column is given by name. Positions do not need one; skip an
    /// existing header by <see cref="MeasurementFormat.SkipLines"/>.</summary>
    internal bool NeedHeader => Required.Any(c => c.Name is not null);

    /// <summary>The same columns with one of <see cref="Members"/> replaced; null is allowed only for an optional one.</summary>
    internal abstract MeasurementColumns With(string member, ColumnSelector? column);

    /// <summary>The points of a table, its nominal points if it has any, and the location of the labels.</summary>
    internal abstract (
        IReadOnlyList<LabelledPoint> Points,
        IReadOnlyList<LabelledPoint> Nominals,
        Place Labels) Read(Table table, MeasurementFormat format);
}
