using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>A correction with the same measurement, job and base program already exists: it must not be applied twice.</summary>
/// <param name="existing">Number of the existing correction.</param>
public sealed class DuplicateCorrectionException(long existing)
    : Exception(string.Create(
        CultureInfo.InvariantCulture,
        $"Correction {existing} has the same measurement, job and base program: a correction is applied once."))
{
    /// <summary>Number of the existing correction.</summary>
    public long Existing => existing;
}
