namespace ErrorMatching.Hmi;

/// <summary>Values over the places of a series, such as errors over key points or figures over pieces.</summary>
/// <param name="Labels">What each place is called.</param>
/// <param name="Values">What is told under the finger at each place, with units.</param>
/// <param name="Lines">The lines.</param>
/// <param name="Bands">Limits that are shaded.</param>
/// <param name="IsHollow">For each place whether its marks are hollow: predicted and not measured. Empty if none is.</param>
/// <param name="Unit">The unit of the values, written at their axis.</param>
/// <param name="IsMagnitude">True if they have no sign.</param>
public sealed record SeriesDrawing(IReadOnlyList<string> Labels, IReadOnlyList<string> Values, IReadOnlyList<SeriesLine> Lines, IReadOnlyList<SeriesBand> Bands, IReadOnlyList<bool> IsHollow, string Unit = "mm", bool IsMagnitude = false)
{
    /// <summary>Places that no line leads to from the place before, such as the first of a feature.</summary>
    public IReadOnlySet<int> Beginnings { get; init; } = new HashSet<int>();

    /// <summary>Values with compensation that lie outside of the limits at their places.</summary>
    public IEnumerable<(int Place, double Value)> Outside =>
        from line in Lines
        where line.Kind is SeriesKind.After
        from band in Bands
        from place in Enumerable.Range(band.First, band.Last - band.First + 1)
        where line.Values[place] is { } value && (value < band.Low || value > band.High)
        select (place, line.Values[place]!.Value);

    /// <summary>How much there is: half a place on either side, zero, all values and all limits.</summary>
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
