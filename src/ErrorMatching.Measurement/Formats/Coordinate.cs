namespace ErrorMatching.Measurement;

/// <summary>Converts cells to coordinates in millimeters.</summary>
internal static class Coordinate
{
    /// <summary>No machine tool is a kilometer long. A larger coordinate has lost its decimal point or has another unit.</summary>
    private const double LargestMm = 1e6;

    public static double Read(Cell cell, MeasurementFormat format)
    {
        var number = cell.Number();
        var millimeters = format.Unit == LengthUnit.Inch ? number.InchesInMillimeters : number.Value;
        return Math.Abs(millimeters) <= LargestMm
            ? millimeters
            : throw cell.Fail(
                MeasurementError.ImplausibleNumber,
                "a coordinate within a kilometer: has its decimal sign been lost, or is the unit of the format wrong?");
    }

    public static void ThrowIfTooMany(int count, Cell label, MeasurementFormat format)
    {
        if (count > format.MaxPoints)
        {
            throw label.Fail(
                MeasurementError.TooManyPoints,
                $"at most {format.MaxPoints} points: is this the right file? If so, raise maxPoints of its format");
        }
    }
}
