using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Reads the nominal surface from an IGES or STEP file, or interpolates a grid of points.</summary>
public static partial class SurfaceReader
{
    /// <summary>Maximum file size in bytes.</summary>
    public const int MaxBytes = ExchangeLimits.MaxBytes;

    /// <summary>No machine tool is a kilometer long.</summary>
    private const double LargestMm = 1e6;

    /// <summary>Reads a surface from a file.</summary>
    /// <param name="bytes">The content of the file.</param>
    /// <param name="file">The file name, for messages. Its extension decides the format if the content does not.</param>
    /// <param name="entity">Name or number, from 1, of the surface if the file has several; null if it has one.</param>
    /// <param name="outsideIsUp">True if the material is below the surface (towards -z), false if above it.</param>
    /// <returns>The surface in millimeters with its boundaries.</returns>
    /// <exception cref="InputException">A grid (<c>.csv</c>) is unreadable or does not determine a surface. The file is broken,
    /// does not contain the surface, or contains several matching ones; or the surface is vertical somewhere or folded, so that up
    /// and down are ambiguous.</exception>
    public static PartSurface Read(ReadOnlySpan<byte> bytes, string file, string? entity, bool outsideIsUp)
    {
        if (bytes.Length > ExchangeLimits.MaxBytes)
        {
            throw InputException.At(
                "too-large", file, $"{bytes.Length} bytes; at most {ExchangeLimits.MaxBytes} are read. Export the one surface alone");
        }

        NoSurface.ThrowIf(bytes, file, IsGrid(file));
        try
        {
            var read = IsGrid(file)
                ? new ReadSurface(
                    Path.GetFileNameWithoutExtension(file),
                    GridSurface.Interpolate(GridReader.Read(bytes.ToArray(), file)),
                    SurfaceRegion.Whole)
                : IsStep(bytes, file) ? new StepSurfaces(new(bytes, file)).Read(entity)
                : new IgesSurfaces(new(bytes, file)).Read(entity);
            var far = read.Spline.Poles.ToArray().Max(p => Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))));
            return far <= LargestMm
                ? new(read.Name, read.Spline, read.Region, SurfaceSide.Of(read, file, outsideIsUp))
                : throw InputException.At(
                    "implausible",
                    file,
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"surface {read.Name} reaches {far:G4} mm away from the origin; a piece within {LargestMm:0} mm is expected: is "
                            + $"the unit of the file wrong?"));
        }
        catch (GeometryException e)
        {
            throw InputException.At("bad-surface", file, e.Message);
        }
    }

    private static bool IsGrid(string file) => file.EndsWith(".csv", StringComparison.OrdinalIgnoreCase);

    // A STEP file identifies itself. An IGES file has a section letter in column 73 of its first record.
    private static bool IsStep(ReadOnlySpan<byte> bytes, string file)
    {
        if (FlatFaces.IsStep(bytes))
        {
            return true;
        }

        var start = Encoding.Latin1.GetString(bytes[..Math.Min(bytes.Length, 80)]);
        var known = file.EndsWith(".stp", StringComparison.OrdinalIgnoreCase) || file.EndsWith(".step", StringComparison.OrdinalIgnoreCase);
        return known && !(start.Length > 72 && start[72] is 'S' or 'G' or 'C');
    }
}
