using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>The limits of a signed deviation in millimeters; both limits are inside the band.</summary>
public sealed record ToleranceBand
{
    /// <summary>A band between two limits.</summary>
    /// <param name="lowerMm">The lower limit.</param>
    /// <param name="upperMm">The upper limit, not below the lower one.</param>
    /// <exception cref="ArgumentException">The limits are reversed or not finite.</exception>
    public ToleranceBand(double lowerMm, double upperMm)
    {
        if (!(lowerMm <= upperMm && double.IsFinite(lowerMm) && double.IsFinite(upperMm)))
        {
            throw new ArgumentException(
                string.Create(CultureInfo.InvariantCulture, $"Found the limits {lowerMm} and {upperMm}; expected the lower one first."),
                nameof(lowerMm));
        }

        (LowerMm, UpperMm) = (lowerMm, upperMm);
    }

    /// <summary>The band of the value 0 alone, which asks for a correction of every deviation.</summary>
    public static ToleranceBand Zero { get; } = new(0, 0);

    /// <summary>The lower limit.</summary>
    public double LowerMm { get; }

    /// <summary>The upper limit.</summary>
    public double UpperMm { get; }

    /// <summary>The distance between the limits; 0 asks for a correction of every deviation.</summary>
    public double WidthMm => UpperMm - LowerMm;

    /// <summary>The limits of the deviation with the opposite sign: a mating job limits part - counterpart; a mating error is
    /// counterpart - part.</summary>
    public ToleranceBand Opposite() => new(-UpperMm, -LowerMm);

    /// <summary>True if a deviation is between the limits or on one of them.</summary>
    public bool Contains(double deviationMm) => ExcessOf(deviationMm) == 0;

    /// <summary>The part of a deviation beyond its limit: positive above the upper limit, negative below the lower one, zero
    /// inside.</summary>
    public double ExcessOf(double deviationMm)
    {
        // Limits and coordinates are decimal fractions of a micrometer, so a difference beyond the 9th decimal is rounding, not
        // deviation.
        const double rounding = 1e-9;
        var excess = deviationMm > UpperMm ? deviationMm - UpperMm : deviationMm < LowerMm ? deviationMm - LowerMm : 0;
        return Math.Abs(excess) <= rounding ? 0 : excess;
    }
}
