using System.Globalization;
using System.Text;

namespace ErrorMatching.Freeform.Tests;

/// <summary>IGES files put together by hand: entities with their parameters as text, laid out in records of 80 columns.</summary>
/// <param name="global">The global section.</param>
internal sealed class IgesText(
    string global = "1H,,1H;,4HTEST,4HTEST,4HTEST,4HTEST,32,38,6,308,15,4HTEST,1.,2,2HMM,1,0.01,15H20260101.000000,1.E-6,1000.;")
{
    private readonly List<(int Type, int Form, string Parameters, string Status, int Matrix, string Label)> _entities = [];

    /// <summary>Terminates the parameters of an entity.</summary>
    public char End { get; init; } = ';';

    /// <summary>False to leave out the start and the terminate section.</summary>
    public bool Framed { get; init; } = true;

    /// <summary>Adds an entity.</summary>
    /// <returns>Its D number.</returns>
    public int Add(
        int type, string parameters, int form = 0, bool dependent = false, bool blanked = false, int matrix = 0, string label = "")
    {
        _entities.Add((type, form, parameters, (blanked ? "01" : "00") + (dependent ? "01" : "00") + "0000", matrix, label));
        return (2 * _entities.Count) - 1;
    }

    /// <summary>The file.</summary>
    public byte[] Bytes()
    {
        var (directory, parameters) = (new List<string>(), new List<string>());
        foreach (var (type, form, text, status, matrix, label) in _entities)
        {
            var sequence = directory.Count + 1;
            var chunks = Chunks(text + End, 64);
            directory.Add(FormattableString.Invariant($"{type,8}{parameters.Count + 1,8}{0,8}{0,8}{0,8}{0,8}{matrix,8}{0,8}{status}"));
            directory.Add(FormattableString.Invariant($"{type,8}{0,8}{0,8}{chunks.Count,8}{form,8}{"",16}{label,8}{0,8}"));
            parameters.AddRange(chunks.Select(c => $"{c,-64} {sequence,7}"));
        }

        var file = new StringBuilder();
        if (Framed)
        {
            Section(file, 'S', ["made by hand".PadRight(72)]);
        }

        Section(file, 'G', Chunks(global, 72).Select(c => c.PadRight(72)));
        Section(file, 'D', directory);
        Section(file, 'P', parameters);
        if (Framed)
        {
            Section(file, 'T', ["S0000001G0000001D0000001P0000001".PadRight(72)]);
        }

        return Encoding.Latin1.GetBytes(file.ToString());
    }

    /// <summary>Reads the file.</summary>
    public PartSurface Read(string? entity = null, bool outsideIsUp = true) => SurfaceReader.Read(Bytes(), "hand.igs", entity, outsideIsUp);

    /// <summary>The parameters of a flat surface from (0, 0) to (width, height) whose parameters run from 0 to 1.</summary>
    public static string Flat(double width, double height, double z = 0) => string.Create(
        CultureInfo.InvariantCulture,
        $"128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,{z},{width},0.,{z},0.,{height},{z},{width},{height},{z},0.,1.,"
            + $"0.,1.");

    // Breaks behind delimiters, as the form asks for numbers.
    private static List<string> Chunks(string text, int width)
    {
        var chunks = new List<string>();
        while (text.Length > width)
        {
            var end = text.LastIndexOfAny([',', '/', ';'], width - 1) + 1;
            end = end == 0 ? width : end;
            chunks.Add(text[..end]);
            text = text[end..];
        }

        chunks.Add(text);
        return chunks;
    }

    private static void Section(StringBuilder file, char letter, IEnumerable<string> records)
    {
        var number = 0;
        foreach (var record in records)
        {
            file.Append(CultureInfo.InvariantCulture, $"{record}{letter}{++number,7}\n");
        }
    }
}
