namespace ErrorMatching.Hmi;

/// <summary>A key point in a table; lengths in mm.</summary>
/// <param name="Point">Its label.</param>
/// <param name="Feature">Its feature.</param>
/// <param name="TheoreticalX">Nominal x.</param>
/// <param name="TheoreticalY">Nominal y.</param>
/// <param name="ActualX">Measured x.</param>
/// <param name="ActualY">Measured y.</param>
/// <param name="CompensationX">Displacement of the program, x.</param>
/// <param name="CompensationY">Displacement of the program, y.</param>
/// <param name="Without">The mating error without compensation: counterpart - part along the normal.</param>
/// <param name="LeftOver">The predicted mating error with compensation, by the same convention, with its 95 % interval if that is
/// known.</param>
/// <param name="IsOutside">True if that error is outside its limits.</param>
internal sealed record PointRow(
    string Point,
    string Feature,
    string TheoreticalX,
    string TheoreticalY,
    string ActualX,
    string ActualY,
    string CompensationX,
    string CompensationY,
    string Without,
    string LeftOver,
    bool IsOutside);
