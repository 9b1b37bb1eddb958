namespace ErrorMatching.Reporting;

/// <summary>The vertical axis of a plot, whose range starts and ends at ticks.</summary>
/// <param name="Step">Distance of the ticks.</param>
/// <param name="First">Index of the lowest tick: its value in steps.</param>
/// <param name="Last">Index of the highest tick.</param>
public readonly record struct PlotAxis(double Step, int First, int Last)
{
    // With a smaller range, an axis would show only rounding.
    private const double SmallestRange = 0.01;

    /// <summary>The lowest value.</summary>
    public double Lowest => First * Step;

    /// <summary>The highest value.</summary>
    public double Highest => Last * Step;

    /// <summary>Returns an axis that covers values and zero, with about 4 to 10 ticks.</summary>
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

        // A margin keeps markers off the frame.
        var room = 0.04 * (high - low);
        var step = RoundNumber.AtLeast((high - low) / 8);
        return new(step, (int)Math.Floor((low - room) / step), (int)Math.Ceiling((high + room) / step));
    }
}
