namespace ErrorMatching.Testing;

/// <summary>How often something random is tried. The gate tries enough to notice what is wrong at many places; <c>ERRORMATCH_THOROUGH=1</c>
/// tries as often as finds what is wrong at few.</summary>
internal static class Depth
{
    private static readonly bool IsThorough = Environment.GetEnvironmentVariable("ERRORMATCH_THOROUGH") == "1";

    /// <summary>The usual number, or the thorough one if that is asked for.</summary>
    public static int Of(int usual, int thorough) => IsThorough ? thorough : usual;
}
