namespace ErrorMatching.Mating.Tests;

/// <summary>Programs of a 6 mm tool about the boundary y = 0 from x = 0 to 50, which block N50 cuts.</summary>
internal static class Programs
{
    /// <summary>The tool goes below the boundary, the counterpart's material is above it.
    /// The boundary's normal to the tool is (0, -1).</summary>
    public const string ToolBelow = "%\nO1000 (COVER)\nN10 G21 G90 G17\nN20 G0 X0. Y-20.\nN30 Z-5.\nN40 G1 X0. Y-3. F300\nN50 X50.\nN60 "
        + "Y-20.\nN70 G0 Z50.\nN80 M30\n%\n";

    /// <summary>The tool goes above the boundary, the material is below it: normal (0, 1).</summary>
    public const string ToolAbove =
        "%\nO1000 (COVER)\nN10 G21 G90 G17\nN20 G0 X0. Y20.\nN30 Z-5.\nN40 G1 X0. Y3. F300\nN50 X50.\nN60 Y20.\nN70 G0 Z50.\nN80 M30\n%\n";

    /// <summary>The path is the boundary itself under G41: the tool is left of travel, above.</summary>
    public const string CompensatedLeft = "%\nO1000 (COVER)\nN10 G21 G90 G17\nN20 G0 X0. Y40.\nN30 G1 G41 D1 Y20. F300\nN40 X0. Y0.\nN50 "
        + "X50.\nN60 Y20.\nN70 G40 Y40.\nN80 M30\n%\n";

    /// <summary>The path is the boundary itself under G42: the tool is right of travel, below.</summary>
    public const string CompensatedRight = "%\nO1000 (COVER)\nN10 G21 G90 G17\nN20 G0 X0. Y-40.\nN30 G1 G42 D1 Y-20. F300\nN40 X0. "
        + "Y0.\nN50 X50.\nN60 Y-20.\nN70 G40 Y-40.\nN80 M30\n%\n";

    /// <summary>A notch under G41, tool above: flanks of slope 4/3 from (0, 0) to the apex (15, -20) to (30, 0).</summary>
    public const string Notch = "%\nO1000\nN10 G21 G90 G17\nN20 G0 X-20. Y20.\nN30 G1 G41 D1 Y0. F300\nN40 X0.\nN50 X15. Y-20.\nN60 X30. "
        + "Y0.\nN70 X50.\nN80 G40 Y20.\nN90 M30\n%\n";

    /// <summary>The same notch with a fillet of radius 3 about (15, -15), which touches the flanks 4 mm from the apex.</summary>
    public const string FilletedNotch = "%\nO1000\nN10 G21 G90 G17\nN20 G0 X-20. Y20.\nN30 G1 G41 D1 Y0. F300\nN40 X0.\nN50 X12.6 "
        + "Y-16.8\nN55 G3 X17.4 Y-16.8 I2.4 J1.8\nN60 G1 X30. Y0.\nN70 X50.\nN80 G40 Y20.\nN90 M30\n%\n";

    /// <summary>A hill under G41: the upper half circle of radius 10 about (20, 0), cut clockwise; the tool is outside.</summary>
    public const string Hill = "%\nO1000\nN10 G21 G90 G17\nN20 G0 X-10. Y20.\nN30 G1 G41 D1 Y0. F300\nN40 X10. Y0.\nN50 G2 X30. Y0. I10. "
        + "J0.\nN60 G1 X50.\nN70 G40 Y20.\nN80 M30\n%\n";
}
