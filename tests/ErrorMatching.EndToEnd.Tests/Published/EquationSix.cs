namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// Equation (6) of the paper as it made tables 6 and 7: X2 = X1 - dX - diameter / 2 with X1 the part, dX = counterpart - part;
/// the tables leave the diameter out (their columns are places of the boundary, not of the tool).
/// </summary>
internal static class EquationSix
{
    public static decimal Converted(decimal part, decimal counterpart, decimal toolDiameter = 0) =>
        part - (counterpart - part) - (toolDiameter / 2);
}
