namespace ErrorMatching.Hmi;

/// <summary>A key point in a table, as it is shown: lengths in mm.</summary>
/// <param name="Point">Its label.</param>
/// <param name="Feature">Its feature.</param>
/// <param name="TheoreticalX">Where it is designed, x.</param>
/// <param name="TheoreticalY">Where it is designed, y.</param>
/// <param name="ActualX">Where it was measured, x.</param>
/// <param name="ActualY">Where it was measured, y.</param>
/// <param name="CompensationX">What is added to the program, x.</param>
/// <param name="CompensationY">What is added to the program, y.</param>
/// <param name="Without">The mating error without compensation: counterpart - part along the normal.</param>
/// <param name="LeftOver">The mating error with it, as predicted, by the same convention.</param>
/// <param name="IsOutside">True if what is left over is outside of its limits.</param>
public sealed record PointRow(
    string Point, string Feature, string TheoreticalX, string TheoreticalY, string ActualX, string ActualY, string CompensationX, string CompensationY, string Without, string LeftOver, bool IsOutside);
