namespace ErrorMatching.Measurement;

/// <summary>Which columns hold what: <see cref="PointColumns"/> or <see cref="FeatureTableColumns"/>.</summary>
public abstract record MeasurementColumns
{
    private protected MeasurementColumns()
    {
    }

    /// <summary>How a file with these columns arranges its points.</summary>
    public abstract MeasurementKind Kind { get; }

    /// <summary>The columns that a file must have.</summary>
    internal abstract IEnumerable<ColumnSelector> Required { get; }

    /// <summary>True if the table starts with a header line: if any column is given by name. Positions need none; one that is there is skipped by <see cref="MeasurementFormat.SkipLines"/>.</summary>
    internal bool NeedHeader => Required.Any(c => c.Name is not null);
}
