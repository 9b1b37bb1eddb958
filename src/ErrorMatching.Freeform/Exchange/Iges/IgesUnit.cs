namespace ErrorMatching.Freeform;

/// <summary>The unit of an IGES file's lengths (IGES 5.3, section 2.2.4.3.14 and .15).</summary>
internal static class IgesUnit
{
    /// <summary>Returns the millimeters per unit.</summary>
    /// <param name="flag">The unit flag.</param>
    /// <param name="name">The unit's name, empty if the file has none.</param>
    /// <returns>Null if flag and name are unknown or contradict each other.</returns>
    public static double? Millimeters(int flag, string name)
    {
        double? byFlag = flag switch
        {
            1 => 25.4,
            2 => 1,
            4 => 304.8,
            5 => 1_609_344,
            6 => 1000,
            7 => 1_000_000,
            8 => 0.0254,
            9 => 0.001,
            10 => 10,
            11 => 0.0000254,
            _ => null,
        };
        var byName = Named(name);
        return flag == 3 ? byName
            : byFlag is null || (byName is not null && byName != byFlag) ? null
            : byFlag;
    }

    private static double? Named(string name) => name.Trim().ToUpperInvariant() switch
    {
        "IN" or "INCH" or "INCHES" => 25.4,
        "MM" or "MILLIMETER" or "MILLIMETERS" => 1,
        "FT" => 304.8,
        "MI" => 1_609_344,
        "M" => 1000,
        "KM" => 1_000_000,
        "MIL" => 0.0254,
        "UM" => 0.001,
        "CM" => 10,
        "UIN" => 0.0000254,
        _ => null,
    };
}
