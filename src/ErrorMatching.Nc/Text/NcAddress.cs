namespace ErrorMatching.Nc;

/// <summary>Codes of multi-letter addresses that describe a motion, used in place of a word's letter.</summary>
internal static class NcAddress
{
    /// <summary>Radius of an arc, <c>CR=</c>.</summary>
    public const byte CircleRadius = (byte)'Z' + 1;

    /// <summary>Opening angle of an arc in degrees, <c>AR=</c>.</summary>
    public const byte OpeningAngle = (byte)'Z' + 2;

    /// <summary>Full turns of a helix beyond the first, <c>TURN=</c>.</summary>
    public const byte Turn = (byte)'Z' + 3;

    /// <summary>X of an intermediate point, <c>I1=</c>.</summary>
    public const byte ThroughX = (byte)'Z' + 4;

    /// <summary>Y of an intermediate point, <c>J1=</c>.</summary>
    public const byte ThroughY = (byte)'Z' + 5;

    /// <summary>Z of an intermediate point, <c>K1=</c>.</summary>
    public const byte ThroughZ = (byte)'Z' + 6;

    /// <summary>The address as written in a program, without the equals sign.</summary>
    public static string NameOf(byte letter) => letter switch
    {
        CircleRadius => "CR",
        OpeningAngle => "AR",
        Turn => "TURN",
        ThroughX => "I1",
        ThroughY => "J1",
        ThroughZ => "K1",
        _ => ((char)letter).ToString(),
    };

    /// <summary>The code of a multi-letter address, upper or lower case; 0 if it is not one.</summary>
    internal static byte Of(ReadOnlySpan<byte> name) => name.Length switch
    {
        2 when Is(name, "CR"u8) => CircleRadius,
        2 when Is(name, "AR"u8) => OpeningAngle,
        2 when Is(name, "I1"u8) => ThroughX,
        2 when Is(name, "J1"u8) => ThroughY,
        2 when Is(name, "K1"u8) => ThroughZ,
        4 when Is(name, "TURN"u8) => Turn,
        _ => 0,
    };

    /// <summary>The letter of the corner word for a name: R rounding, C chamfer by its legs, F chamfer by its width, M modal rounding; 0
    /// if it is not one.</summary>
    internal static byte CornerOf(ReadOnlySpan<byte> name) => name.Length switch
    {
        3 when Is(name, "RND"u8) => (byte)'R',
        3 when Is(name, "CHR"u8) => (byte)'C',
        3 when Is(name, "CHF"u8) => (byte)'F',
        4 when Is(name, "RNDM"u8) => (byte)'M',
        _ => 0,
    };

    private static bool Is(ReadOnlySpan<byte> name, ReadOnlySpan<byte> upper) => System.Text.Ascii.EqualsIgnoreCase(name, upper);
}
