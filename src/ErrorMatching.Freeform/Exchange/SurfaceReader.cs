using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Reads the nominal surface from an IGES or STEP file, or lays it through a grid of points.</summary>
public static partial class SurfaceReader
{
    /// <summary>Largest file that is read, in bytes.</summary>
    public const int MaxBytes = ExchangeLimits.MaxBytes;

    /// <summary>No machine of this trade is a kilometer long.</summary>
    private const double LargestMm = 1e6;

    /// <summary>The surface of a file.</summary>
    /// <param name="bytes">What is in the file.</param>
    /// <param name="file">Its name; it goes into messages, and its extension decides where the content does not.</param>
    /// <param name="entity">Name or number, from 1, of the surface where the file has several; null if it has one.</param>
    /// <param name="outsideIsUp">True if the material lies below the surface (towards -z), false if above it.</param>
    /// <returns>The surface in millimetres with its limits.</returns>
    /// <exception cref="Measurement.MeasurementException">A grid (<c>.csv</c>) cannot be read, or its points determine no surface.</exception>
    /// <exception cref="FreeformException">The file is broken, has no such surface or several, or the surface is upright somewhere or folded, so that up and down tell nothing.</exception>
    public static PartSurface Read(ReadOnlySpan<byte> bytes, string file, string? entity, bool outsideIsUp)
    {
        if (bytes.Length > ExchangeLimits.MaxBytes)
        {
            throw new FreeformException("too-large", file, $"{bytes.Length} bytes; at most {ExchangeLimits.MaxBytes} are read. Export the one surface alone");
        }

        try
        {
            var read = IsGrid(file) ? new ReadSurface(Path.GetFileNameWithoutExtension(file), GridSurface.Interpolate(GridReader.Read(bytes.ToArray(), file)), SurfaceRegion.Whole)
                : IsStep(bytes, file) ? new StepSurfaces(new(bytes, file)).Read(entity)
                : new IgesSurfaces(new(bytes, file)).Read(entity);
            var far = read.Spline.Poles.ToArray().Max(p => Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z))));
            return far <= LargestMm
                ? new(read.Name, read.Spline, read.Region, SurfaceSide.Of(read, file, outsideIsUp))
                : throw new FreeformException("implausible", file, string.Create(CultureInfo.InvariantCulture, $"surface {read.Name} reaches {far:G4} mm away from the origin; a piece within {LargestMm:0} mm is expected: is the unit of the file wrong?"));
        }
        catch (GeometryException e)
        {
            throw new FreeformException("bad-surface", file, e.Message);
        }
    }

    private static bool IsGrid(string file) => file.EndsWith(".csv", StringComparison.OrdinalIgnoreCase);

    // A STEP file says what it is; an IGES file shows by the letter of a section in column 73 of its first record.
    private static bool IsStep(ReadOnlySpan<byte> bytes, string file)
    {
        var start = Encoding.Latin1.GetString(bytes[..Math.Min(bytes.Length, 4096)]);
        if (start.AsSpan(StepLexer.SkipBlanks(start, 0)).StartsWith("ISO-10303-21"))
        {
            return true;
        }

        var known = file.EndsWith(".stp", StringComparison.OrdinalIgnoreCase) || file.EndsWith(".step", StringComparison.OrdinalIgnoreCase);
        return known && !(start.Length > 72 && start[72] is 'S' or 'G' or 'C');
    }
}
