using System.Globalization;
using System.Text;

namespace ErrorMatching.Freeform;

/// <summary>Collects and writes the records of an IGES file (IGES 5.3, section 2.2).</summary>
internal sealed class IgesRecords(string product)
{
    private const int LabelLength = 8;

    // The format requires dates. They are constant, so that the same content gives the same file.
    private const string Date = "20000101.000000";

    private readonly List<string[]> _directory = [];
    private readonly List<string> _parameters = [];

    /// <summary>Reserves the next directory entry.</summary>
    /// <returns>Its D number.</returns>
    public int Reserve()
    {
        _directory.Add([]);
        return (2 * _directory.Count) - 1;
    }

    /// <summary>Writes an entity into a reserved entry.</summary>
    /// <param name="sequence">Its D number.</param>
    /// <param name="type">Its type.</param>
    /// <param name="form">Its form.</param>
    /// <param name="dependent">True if it is only part of another entity.</param>
    /// <param name="name">Its name, written as a label, or as a name property if it is too long; empty for none.</param>
    /// <param name="values">Its parameters after the type.</param>
    public void Fill(int sequence, int type, int form, bool dependent, string name, IReadOnlyList<IgesValue> values)
    {
        var plain = Plain(name);
        var label = plain.Length <= LabelLength ? plain : "";
        List<IgesValue> all = [type, .. values];
        if (plain.Length > LabelLength)
        {
            var property = Reserve();
            Fill(property, 406, 15, dependent: true, "", [1, IgesValue.String(plain)]);
            all.AddRange([0, 1, property]);
        }

        var first = _parameters.Count;
        Wrap(all, 64, line => _parameters.Add($"{line,-64}{sequence,8}"));
        _directory[(sequence - 1) / 2] =
        [
            FormattableString.Invariant($"{type,8}{first + 1,8}{0,8}{0,8}{0,8}{0,8}{0,8}{0,8}{(dependent ? "00010000" : "00000000")}"),
            FormattableString.Invariant($"{type,8}{0,8}{0,8}{_parameters.Count - first,8}{form,8}{"",8}{"",8}{label,8}{0,8}"),
        ];
    }

    /// <summary>Returns the complete file.</summary>
    /// <param name="largest">Largest coordinate in millimeters.</param>
    public byte[] ToBytes(double largest)
    {
        var text = new StringBuilder();
        var start = Section(text, 'S', [$"{Plain(product),-72}"[..72]]);
        IgesValue empty = new("");
        var name = IgesValue.String(Plain(product));
        List<string> global = [];
        Wrap(
            [
                IgesValue.String(","), IgesValue.String(";"), name, name, IgesValue.String("ErrorMatching"),
                IgesValue.String("ErrorMatching"), 32, 308, 15, 308, 15, name, 1.0, 2,
                IgesValue.String("MM"), 1, 0.01, IgesValue.String(Date), 1e-6, largest, empty, empty, 11, 0, IgesValue.String(Date),
            ],
            72,
            line => global.Add($"{line,-72}"));
        var globals = Section(text, 'G', global);
        var entries = Section(text, 'D', _directory.SelectMany(d => d));
        var parameters = Section(text, 'P', _parameters);
        Section(text, 'T', [FormattableString.Invariant($"S{start,7}G{globals,7}D{entries,7}P{parameters,7}{"",40}")]);
        return Encoding.ASCII.GetBytes(text.ToString());
    }

    private static int Section(StringBuilder text, char letter, IEnumerable<string> records)
    {
        var number = 0;
        foreach (var record in records)
        {
            text.Append(CultureInfo.InvariantCulture, $"{record}{letter}{++number,7}\n");
        }

        return number;
    }

    // A number must not be split between records; a string may be.
    private static void Wrap(List<IgesValue> values, int width, Action<string> add)
    {
        var line = new StringBuilder();
        for (var i = 0; i < values.Count; i++)
        {
            var token = values[i].Text + (i == values.Count - 1 ? ";" : ",");
            if (line.Length + token.Length > width && line.Length > 0 && token.Length <= width)
            {
                add(line.ToString());
                line.Clear();
            }

            for (var at = 0; at < token.Length;)
            {
                var part = Math.Min(width - line.Length, token.Length - at);
                line.Append(token, at, part);
                at += part;
                if (line.Length == width)
                {
                    add(line.ToString());
                    line.Clear();
                }
            }
        }

        if (line.Length > 0)
        {
            add(line.ToString());
        }
    }

    // IGES allows only the printable ASCII characters.
    private static string Plain(string name) => string.Concat(name.Select(c => c is >= ' ' and <= '~' ? c : '_'));
}
