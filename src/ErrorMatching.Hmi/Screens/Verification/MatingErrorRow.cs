namespace ErrorMatching.Hmi;

/// <summary>A key point in a table of mating errors; lengths in mm along the normal.</summary>
/// <param name="Point">Its label.</param>
/// <param name="Feature">Its feature.</param>
/// <param name="Low">The lower limit of the error.</param>
/// <param name="High">The upper limit of the error.</param>
/// <param name="Before">The error without compensation.</param>
/// <param name="After">The error with compensation.</param>
/// <param name="Verdict">Whether it is within its limits, in a word.</param>
/// <param name="IsOutside">True if it is outside its limits.</param>
internal sealed record MatingErrorRow(
    string Point, string Feature, string Low, string High, string Before, string After, string Verdict, bool IsOutside);
