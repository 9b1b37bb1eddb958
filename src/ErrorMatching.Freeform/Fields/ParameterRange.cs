namespace ErrorMatching.Freeform;

/// <summary>The range of a parameter that samples cover, and its map to -1 to 1.</summary>
internal readonly record struct ParameterRange(double Low, double High)
{
    public static ParameterRange Of(IEnumerable<double> values)
    {
        var (low, high) = (double.PositiveInfinity, double.NegativeInfinity);
        foreach (var value in values)
        {
            (low, high) = (Math.Min(low, value), Math.Max(high, value));
        }

        return new(low, high);
    }

    public double ToUnit(double value) => High > Low ? (((value - Low) - (High - value)) / (High - Low)) : 0;

    public double FromUnit(double t) => Low + ((High - Low) * (t + 1) / 2);
}
