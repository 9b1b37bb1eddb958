namespace ErrorMatching.Hmi;

/// <summary>Values over a series of places, such as errors over key points or results over pieces.</summary>
/// <param name="Labels">The label of each place.</param>
/// <param name="Values">The text shown for each place on tapping, with units.</param>
/// <param name="Lines">The lines.</param>
/// <param name="Bands">The shaded limits.</param>
/// <param name="IsHollow">For each place, whether its marks are hollow: predicted, not measured. Empty if none are.</param>
/// <param name="Unit">The unit of the values, written at their axis.</param>
/// <param name="IsMagnitude">True if the values have no sign.</param>
internal sealed record SeriesDrawing(
    IReadOnlyList<string> Labels,
    IReadOnlyList<string> Values,
    IReadOnlyList<SeriesLine> Lines,
    IReadOnlyList<SeriesBand> Bands,
    IReadOnlyList<bool> IsHollow,
    string Unit = "mm",
    bool IsMagnitude = false)
{
    /// <summary>Places not joined to the previous place, such as the first of a feature.</summary>
    public IReadOnlySet<int> Beginnings { get; init; } = new HashSet<int>();

    /// <summary>Values with compensation that are outside the limits at their places.</summary>
    public IEnumerable<(int Place, double Value)> Outside =>
        from line in Lines
        where line.Kind is SeriesKind.After
        from band in Bands
        from place in Enumerable.Range(band.First, band.Last - band.First + 1)
        where line.Values[place] is { } value && (value < band.Low || value > band.High)
        select (place, line.Values[place]!.Value);

    /// <summary>The extent: half a place on either side, zero, all values and all limits.</summary>
    public PlotBox Extent
    {
        get
        {
            if (Labels.Count == 0)
            {
                return PlotBox.Empty;
            }

            double[] values = [0, .. Lines.SelectMany(l => l.Values).OfType<double>(), .. Bands.SelectMany(b => new[] { b.Low, b.High })];
            return new(-0.5, values.Min(), Labels.Count - 0.5, Math.Max(values.Max(), values.Min() + 1e-6));
        }
    }
}

/// <summary>One line of a series plot.</summary>
/// <param name="Kind">Its meaning.</param>
/// <param name="Name">Its name in the legend.</param>
/// <param name="Values">The value at each place; null if there is none.</param>
internal sealed record SeriesLine(SeriesKind Kind, string Name, IReadOnlyList<double?> Values)
{
    /// <summary>Places that this line does not join to the previous place, in addition to those of the whole drawing.</summary>
    public IReadOnlySet<int> Beginnings { get; init; } = new HashSet<int>();
}

/// <summary>Limits over a range of places in a series.</summary>
/// <param name="First">The first place, from 0.</param>
/// <param name="Last">The last place.</param>
/// <param name="Low">The lower limit.</param>
/// <param name="High">The upper limit.</param>
internal sealed record SeriesBand(int First, int Last, double Low, double High);

/// <summary>The meaning of a plot line, which decides how it looks: never by color alone.</summary>
internal enum SeriesKind
{
    /// <summary>Without compensation: a line with circles.</summary>
    Before,

    /// <summary>With compensation: a line with diamonds.</summary>
    After,

    /// <summary>A second figure without compensation: dashes.</summary>
    BeforeMean,

    /// <summary>A second figure with compensation: dashes.</summary>
    AfterMean,
}
