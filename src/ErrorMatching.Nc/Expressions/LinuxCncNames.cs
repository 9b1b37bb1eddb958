namespace ErrorMatching.Nc;

/// <summary>Named parameters that LinuxCNC itself provides (LinuxCNC 2.9, predefined named parameters); only the machine knows their
/// values.</summary>
internal static class LinuxCncNames
{
    private static readonly HashSet<string> Predefined = new(StringComparer.Ordinal)
    {
        "_VMAJOR", "_VMINOR", "_LINE", "_MOTION_MODE", "_PLANE", "_CCOMP", "_METRIC", "_IMPERIAL", "_ABSOLUTE", "_INCREMENTAL",
        "_INVERSE_TIME", "_UNITS_PER_MINUTE",
        "_UNITS_PER_REV", "_COORD_SYSTEM", "_TOOL_OFFSET", "_RETRACT_R_PLANE", "_RETRACT_OLD_Z", "_SPINDLE_RPM_MODE", "_SPINDLE_CSS_MODE",
        "_IJK_ABSOLUTE_MODE",
        "_LATHE_DIAMETER_MODE", "_LATHE_RADIUS_MODE", "_SPINDLE_ON", "_SPINDLE_CW", "_MIST", "_FLOOD", "_SPEED_OVERRIDE", "_FEED_OVERRIDE",
        "_ADAPTIVE_FEED", "_FEED_HOLD",
        "_FEED", "_RPM", "_X", "_Y", "_Z", "_A", "_B", "_C", "_U", "_V", "_W", "_ABS_X", "_ABS_Y", "_ABS_Z", "_ABS_A", "_ABS_B", "_ABS_C",
        "_CURRENT_TOOL", "_CURRENT_POCKET", "_SELECTED_TOOL", "_SELECTED_POCKET", "_TASK", "_CALL_LEVEL", "_REMAP_LEVEL",
    };

    /// <summary>The last of the numbered parameters (measured with rs274).</summary>
    public const int LastNumber = 5601;

    public static bool IsPredefined(string name) => Predefined.Contains(name);

    public static bool IsOfMachine(string name) =>
        IsPredefined(name)
            || name.StartsWith("_INI[", StringComparison.Ordinal)
            || name.StartsWith("_HAL[", StringComparison.Ordinal);

    /// <summary>True for the numbers of the tool in the spindle and of the place where it is.</summary>
    public static bool IsReadOnly(int number) => number is (>= 5400 and <= 5413) or (>= 5420 and <= 5428);
}
