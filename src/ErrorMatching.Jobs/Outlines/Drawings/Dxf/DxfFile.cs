using System.Globalization;
using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>The structure of a DXF file: its unit, layers and blocks, and where the groups of each entity are.</summary>
internal sealed class DxfFile
{
    private const string Line = "LINE", Polyline = "POLYLINE", Vertex = "VERTEX", SequenceEnd = "SEQEND";

    private static readonly string[] Kinds =
        [Line, "LWPOLYLINE", "ARC", "CIRCLE", "INSERT", "SPLINE", "ELLIPSE", Polyline, Vertex, SequenceEnd];

    private readonly Dictionary<string, (string Name, bool IsHidden, bool IsFrozen)> _layers = new(StringComparer.OrdinalIgnoreCase);
    private readonly Dictionary<string, DxfBlock> _blocks = new(StringComparer.OrdinalIgnoreCase);
    private readonly DxfText _text = new();
    private readonly DxfNotes _notes;
    private int _entities;
    private (byte[] Bytes, string Name) _lastName = ([], "");

    /// <summary>Reads the sections of a file.</summary>
    /// <exception cref="InputException">It is no DXF file, or it is broken.</exception>
    public DxfFile(DxfGroups groups, DxfNotes notes)
    {
        (Groups, _notes) = (groups, notes);
        for (Groups.Next(); !IsKind("EOF"u8); Groups.Next())
        {
            if (Groups.Code == 9)
            {
                // Old versions of dxflib end the header's section twice.
                Header();
                continue;
            }

            if (!IsKind("SECTION"u8))
            {
                throw Unexpected("a section (SECTION) or the end of the file (EOF)");
            }

            Groups.Next();
            if (Groups.Code != 2)
            {
                throw Unexpected("the name of the section in group 2");
            }

            Section(Groups.Latin());
        }
    }

    /// <summary>The groups.</summary>
    public DxfGroups Groups { get; }

    /// <summary>The code of the unit (INSUNITS) and its place; null if the header has none.</summary>
    public (int Code, int Place)? Unit { get; private set; }

    /// <summary>What is drawn.</summary>
    public DxfBlock Drawing { get; } = new("");

    /// <summary>Returns a block by its name.</summary>
    public DxfBlock? Block(string name) => _blocks.GetValueOrDefault(name);

    /// <summary>The name of a layer as the table of layers spells it, and whether it is off or frozen.</summary>
    public (string Name, bool IsHidden, bool IsFrozen) Layer(string name)
    {
        if (!_layers.TryGetValue(name, out var layer))
        {
            layer = (name, false, false);
            _layers.Add(name, layer);
        }

        return layer;
    }

    /// <summary>The present group as a name.</summary>
    public string Name()
    {
        // Neighbors are mostly on the same layer.
        if (!Groups.Text.SequenceEqual(_lastName.Bytes))
        {
            _lastName = (Groups.Text.ToArray(), _text.Decode(Groups.Text));
        }

        return _lastName.Name;
    }

    private bool IsKind(ReadOnlySpan<byte> kind) => Groups.Code == 0 && Groups.Text.SequenceEqual(kind);

    private InputException Unexpected(string expected)
    {
        var found = string.Create(CultureInfo.InvariantCulture, $"group {Groups.Code} with {DrawingLimits.Quote(Groups.Latin())}");
        return Groups.Fail("bad-structure", $"{found}; {expected} is expected");
    }

    private void Section(string name)
    {
        Groups.Next();
        switch (name)
        {
            case "HEADER":
                Header();
                break;
            case "TABLES":
                Tables();
                break;
            case "BLOCKS":
                Blocks();
                break;
            case "ENTITIES":
                Entities(Drawing, "ENDSEC");
                break;
            default:
                Skip(name);
                break;
        }
    }

    private void CheckInside(string name)
    {
        if (IsKind("EOF"u8) || IsKind("SECTION"u8))
        {
            throw Unexpected($"the end (ENDSEC) of section {DrawingLimits.Quote(name)}");
        }
    }

    private void Skip(string section)
    {
        for (; !IsKind("ENDSEC"u8); Groups.Next())
        {
            CheckInside(section);
            if (IsKind("SPATIAL_FILTER"u8))
            {
                _notes.Clip();
            }
        }
    }

    private void Header()
    {
        var variable = "";
        for (; !IsKind("ENDSEC"u8); Groups.Next())
        {
            CheckInside("HEADER");
            switch (Groups.Code, variable)
            {
                case (9, _):
                    variable = Groups.Latin();
                    break;
                case (70, "$INSUNITS"):
                    Unit = (Groups.Integer("$INSUNITS"), Groups.Place);
                    break;
                case (3, "$DWGCODEPAGE"):
                    _text.SetPage(Groups.Latin());
                    break;
                case (1, "$ACADVER"):
                    _text.SetVersion(Groups.Latin());
                    break;
            }
        }
    }

    private void Tables()
    {
        while (!IsKind("ENDSEC"u8))
        {
            CheckInside("TABLES");
            if (!IsKind("LAYER"u8))
            {
                Groups.Next();
                continue;
            }

            var (name, color, flags) = ("", 7, 0);
            for (Groups.Next(); Groups.Code != 0; Groups.Next())
            {
                switch (Groups.Code)
                {
                    case 2:
                        name = Name();
                        break;
                    case 62:
                        color = Groups.Integer("LAYER");
                        break;
                    case 70:
                        flags = Groups.Integer("LAYER");
                        break;
                }
            }

            _layers[name] = (name, color < 0 || (flags & 1) != 0, (flags & 1) != 0);
        }
    }

    private void Blocks()
    {
        while (!IsKind("ENDSEC"u8))
        {
            CheckInside("BLOCKS");
            if (!IsKind("BLOCK"u8))
            {
                throw Unexpected("a BLOCK");
            }

            var (place, name, x, y, flags) = (Groups.Place, "", 0.0, 0.0, 0);
            for (Groups.Next(); Groups.Code != 0; Groups.Next())
            {
                switch (Groups.Code)
                {
                    case 2:
                        name = Name();
                        break;
                    case 10:
                        x = Groups.Number("BLOCK");
                        break;
                    case 20:
                        y = Groups.Number("BLOCK");
                        break;
                    case 70:
                        flags = Groups.Integer("BLOCK");
                        break;
                }
            }

            var block = new DxfBlock(name) { Base = new(x, y), IsExternal = (flags & 4) != 0 };
            // Nothing can insert a block without a name.
            if (name.Length > 0 && !_blocks.TryAdd(name, block))
            {
                throw Groups.FailAt(
                    "bad-structure", place, $"a second block {DrawingLimits.Quote(name)}; blocks with different names are expected");
            }

            Entities(block, "ENDBLK");

            // The end of a block has a handle and a layer.
            do
            {
                Groups.Next();
            }
            while (Groups.Code != 0);
        }
    }

    private void Entities(DxfBlock block, string end)
    {
        var last = Encoding.ASCII.GetBytes(end);
        while (!IsKind(last))
        {
            CheckInside(block == Drawing ? "ENTITIES" : "BLOCKS");
            if (Groups.Code != 0 || IsKind("ENDSEC"u8) || IsKind("BLOCK"u8))
            {
                throw Unexpected($"an entity or {end}");
            }

            var kind = KnownKind();
            if (kind is null)
            {
                var other = block.Others.Count < DxfLimits.MaxNamed ? Groups.Latin() : "other";
                block.Others[other] = block.Others.GetValueOrDefault(other) + 1;
                SkipGroups();
            }
            else if (kind is SequenceEnd)
            {
                // After the attributes of an INSERT.
                SkipGroups();
            }
            else
            {
                Entity(block, kind);
            }
        }
    }

    private string? KnownKind()
    {
        foreach (var kind in Kinds)
        {
            if (Ascii.Equals(Groups.Text, kind))
            {
                return kind;
            }
        }

        return null;
    }

    private void SkipGroups()
    {
        do
        {
            Groups.Next();
        }
        while (Groups.Code != 0);
    }

    private void Entity(DxfBlock block, string kind)
    {
        if (kind is Vertex)
        {
            throw Unexpected("a POLYLINE before its VERTEX");
        }

        var label = $"{kind} at {Groups.Where(Groups.Place)}";
        if (++_entities > DxfLimits.MaxEntities)
        {
            throw Groups.Fail("too-large", string.Create(
                CultureInfo.InvariantCulture, $"{label}: more than {DxfLimits.MaxEntities} entities with curves; fewer are expected"));
        }

        var entity = new DxfEntity(kind, Groups.Place, label, Groups.Position);
        block.Entities.Add(entity);
        for (Groups.Next(); Groups.Code != 0; Groups.Next())
        {
            switch (Groups.Code)
            {
                case 8:
                    entity.Layer = Name();
                    break;
                case 60:
                    entity.IsInvisible = Groups.Integer(label) == 1;
                    break;
                case 67:
                    entity.IsPaper = Groups.Integer(label) == 1;
                    break;
            }
        }

        if (kind is Polyline)
        {
            while (IsKind("VERTEX"u8))
            {
                SkipGroups();
            }

            if (!IsKind("SEQEND"u8))
            {
                throw Unexpected($"a VERTEX or the end (SEQEND) of {label}");
            }

            SkipGroups();
        }
    }
}
