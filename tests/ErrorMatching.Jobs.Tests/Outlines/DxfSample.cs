using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Writes small DXF files from groups such as <c>"0 LINE"</c>, in text and in binary form.</summary>
internal sealed class DxfSample
{
    private readonly List<(int Code, string Value)> _header = [];
    private readonly List<(int Code, string Value)> _tables = [];
    private readonly List<(int Code, string Value)> _blocks = [];
    private readonly List<(int Code, string Value)> _entities = [];

    public static DxfSample Of(params string[] entities) => new DxfSample().Entities(entities);

    public DxfSample Unit(int code) => Header("9 $INSUNITS", FormattableString.Invariant($"70 {code}"));

    public DxfSample Header(params string[] groups) => Add(_header, groups);

    public DxfSample Layer(string name, int color = 7, int flags = 0) =>
        Add(_tables, "0 LAYER", "2 " + name, FormattableString.Invariant($"70 {flags}"), FormattableString.Invariant($"62 {color}"));

    public DxfSample Block(string name, double x, double y, params string[] entities)
    {
        Add(_blocks, "0 BLOCK", "8 0", "2 " + name, "70 0");
        Add(_blocks, FormattableString.Invariant($"10 {x:r}"), FormattableString.Invariant($"20 {y:r}"));
        Add(_blocks, entities);
        return Add(_blocks, "0 ENDBLK", "8 0");
    }

    public DxfSample Entities(params string[] groups) => Add(_entities, groups);

    public List<(int Code, string Value)> Groups()
    {
        List<(int, string)> all = [];
        Section("HEADER", _header);
        Section("TABLES", _tables.Count > 0 ? [(0, "TABLE"), (2, "LAYER"), .. _tables, (0, "ENDTAB")] : []);
        Section("BLOCKS", _blocks);
        Section("ENTITIES", _entities);
        all.Add((0, "EOF"));
        return all;

        void Section(string name, List<(int, string)> content)
        {
            if (content.Count > 0)
            {
                all.AddRange([(0, "SECTION"), (2, name), .. content, (0, "ENDSEC")]);
            }
        }
    }

    public string Text(string end = "\n")
    {
        var text = new StringBuilder();
        foreach (var (code, value) in Groups())
        {
            text.Append(CultureInfo.InvariantCulture, $"{code,3}{end}{value}{end}");
        }

        return text.ToString();
    }

    public byte[] Bytes() => Encoding.UTF8.GetBytes(Text());

    public byte[] Binary(bool hasShortCodes)
    {
        var stream = new MemoryStream();
        var writer = new BinaryWriter(stream);
        writer.Write("AutoCAD Binary DXF\r\n\x1a\0"u8);
        foreach (var (code, value) in Groups())
        {
            if (!hasShortCodes)
            {
                writer.Write((short)code);
            }
            else if (code < 255)
            {
                writer.Write((byte)code);
            }
            else
            {
                writer.Write((byte)255);
                writer.Write((short)code);
            }

            switch (code)
            {
                case >= 10 and < 60 or >= 210 and < 240:
                    writer.Write(double.Parse(value, CultureInfo.InvariantCulture));
                    break;
                case >= 60 and < 80:
                    writer.Write(short.Parse(value, CultureInfo.InvariantCulture));
                    break;
                case >= 90 and < 100 or 1071:
                    writer.Write(int.Parse(value, CultureInfo.InvariantCulture));
                    break;
                case >= 310 and < 320:
                    var chunk = Convert.FromHexString(value);
                    writer.Write((byte)chunk.Length);
                    writer.Write(chunk);
                    break;
                default:
                    writer.Write(Encoding.UTF8.GetBytes(value));
                    writer.Write((byte)0);
                    break;
            }
        }

        return stream.ToArray();
    }

    public Drawing Read(double? unitMm = null) => DxfReader.Read(Bytes(), "part.dxf", unitMm);

    public static InputException Refused(byte[] bytes, double? unitMm = null) =>
        Assert.Throws<InputException>(() => DxfReader.Read(bytes, "part.dxf", unitMm));

    public InputException Refused() => Refused(Bytes());

    /// <summary>The groups of an entity: its kind, its layer and values such as <c>10, 1.5</c>.</summary>
    public static string[] Entity(string kind, string layer, params double[] codesAndValues)
    {
        List<string> groups = ["0 " + kind, "8 " + layer];
        for (var i = 0; i < codesAndValues.Length; i += 2)
        {
            groups.Add(FormattableString.Invariant($"{(int)codesAndValues[i]} {codesAndValues[i + 1]:r}"));
        }

        return [.. groups];
    }

    private DxfSample Add(List<(int, string)> to, params string[] groups)
    {
        foreach (var group in groups)
        {
            var blank = group.IndexOf(' ', StringComparison.Ordinal);
            to.Add((int.Parse(group.AsSpan(0, blank), CultureInfo.InvariantCulture), group[(blank + 1)..]));
        }

        return this;
    }
}
