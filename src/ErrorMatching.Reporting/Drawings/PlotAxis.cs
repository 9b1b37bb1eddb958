namespace ErrorMatching.Reporting;

/// <summary>The vertical axis of a plot: a range that ends at ticks.</summary>
/// <param name="Step">Distance of the ticks.</param>
/// <param name="First">Number of the lowest tick: it stands at this many steps.</param>
/// <param name="Last">Number of the highest tick.</param>
public readonly record struct PlotAxis(double Step, int First, int Last)
{
    // Below this an axis would show nothing but rounding.
    private const double SmallestRange = 0.01;

    /// <summary>The lowest value.</summary>
    public double Lowest => First * Step;

    /// <summary>The highest value.</summary>
    public double Highest => Last * Step;

    /// <summary>An axis that shows some values and zero, with 4 to 10 ticks or so.</summary>
    public static PlotAxis Around(IEnumerable<double> values)
    {
        var (low, high) = (0.0, 0.0);
        foreach (var value in values)
        {
            (low, high) = (Math.Min(low, value), Math.Max(high, value));
        }

        if (high - low < SmallestRange)
        {
            (low, high) = (low - (SmallestRange / 2), high + (SmallestRange / 2));
        }

        // A little room keeps markers off the frame.
        var room = 0.04 * (high - low);
        var step = RoundNumber.AtLeast((high - low) / 8);
        return new(step, (int)Math.Floor((low - room) / step), (int)Math.Ceiling((high + room) / step));
    }
}
