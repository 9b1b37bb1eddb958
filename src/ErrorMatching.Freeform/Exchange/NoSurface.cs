using System.Buffers.Binary;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Recognizes files that are often taken for surfaces: meshes and clouds of points.</summary>
internal static class NoSurface
{
    private static readonly string[] Meshes = [".stl", ".obj", ".ply", ".3mf", ".off"];

    /// <summary>Throws if a file is a mesh, or a table of points without a grid.</summary>
    /// <exception cref="InputException"><c>mesh-as-surface</c>, <c>cloud-as-surface</c>.</exception>
    public static void ThrowIf(ReadOnlySpan<byte> bytes, string file, bool isTable)
    {
        if (IsMesh(bytes, file))
        {
            throw InputException.At(
                "mesh-as-surface",
                file,
                "found a mesh of triangles, such as STL; expected a surface: export it from the CAD system as STEP or IGES. The facets "
                    + "of a mesh are not the surface, and would be cut.",
                1,
                1);
        }

        if (isTable && HasPointsOnly(bytes))
        {
            throw InputException.At(
                "cloud-as-surface",
                file,
                "found points without their places in a grid; expected the columns i, j, x, y, z, with i along each curve and j across. If "
                    + "these are measured points, name them after --measured. If the surface comes from a CAD system, export it as STEP or "
                    + "IGES.",
                1,
                1);
        }
    }

    private static bool IsMesh(ReadOnlySpan<byte> bytes, string file)
    {
        const int header = 80, facet = 50;
        var isBinary = bytes.Length > header + 4
            && BinaryPrimitives.ReadUInt32LittleEndian(bytes[header..]) is > 0 and var count
            && bytes.Length == header + 4 + ((long)count * facet);
        var head = bytes[..Math.Min(bytes.Length, 4096)];
        return isBinary
            || Array.Exists(Meshes, m => file.EndsWith(m, StringComparison.OrdinalIgnoreCase))
            || (head.TrimStart(" \t\r\n"u8).StartsWith("solid"u8) && head.IndexOf("facet"u8) >= 0);
    }

    private static bool HasPointsOnly(ReadOnlySpan<byte> bytes)
    {
        var line = bytes[..Math.Min(bytes.Length, 4096)].TrimStart(" \t\r\n\uFEFF"u8);
        var end = line.IndexOfAny((byte)'\n', (byte)'\r');
        var names = Encoding.Latin1.GetString(end < 0 ? line : line[..end]).ToLowerInvariant()
            .Split([',', ';', '\t']).Select(n => n.Trim().Trim('"').Trim()).ToHashSet(StringComparer.Ordinal);
        return "xyz".All(a => names.Contains($"{a}") || names.Contains($"{a}_mm"))
            && !names.Contains("i")
            && !names.Contains("j");
    }
}
