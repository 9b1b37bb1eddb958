namespace ErrorMatching.Measurement;

/// <summary>Converts cells to coordinates in millimeters.</summary>
internal static class Coordinate
{
    /// <summary>No machine tool is a kilometer long. A larger coordinate has lost its decimal point or has another unit.</summary>
    private const double LargestMm = 1e6;

    public static double Read(Cell cell, LengthUnit unit)
    {
        var number = cell.Number();
        var millimeters = unit == LengthUnit.Inch ? number.InchesInMillimeters : number.Value;
        return Checked(millimeters, cell);
    }

    /// <summary>A coordinate in millimeters, if it can be one.</summary>
    public static double Checked(double millimeters, Cell cell) => Math.Abs(millimeters) <= LargestMm
        ? millimeters
        : throw cell.Fail(
            MeasurementError.ImplausibleNumber,
            "a coordinate within a kilometer: has its decimal sign been lost, or is the unit of the format wrong?");

    public static void ThrowIfTooMany(int count, Cell label, int maxPoints)
    {
        if (count > maxPoints)
        {
            throw label.Fail(
                MeasurementError.TooManyPoints,
                $"at most {maxPoints} points: is this the right file? If so, raise maxPoints of its format");
        }
    }
}
