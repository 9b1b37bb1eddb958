using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>Measurement, job and base program are those of a correction that is there already: it must not be applied a second time.</summary>
/// <param name="existing">Number of the correction that is there.</param>
public sealed class DuplicateCorrectionException(long existing)
    : Exception(string.Create(CultureInfo.InvariantCulture, $"Correction {existing} has the same measurement, job and base program: a correction is applied once."))
{
    /// <summary>Number of the correction that is there.</summary>
    public long Existing => existing;
}
