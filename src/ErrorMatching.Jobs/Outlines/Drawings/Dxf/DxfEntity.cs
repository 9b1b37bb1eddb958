using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs;

/// <summary>An entity with curves, or an INSERT. Its geometry is read when it is drawn, so that an error in a block that nobody inserts
/// does not matter.</summary>
/// <param name="kind">Its name in DXF.</param>
/// <param name="place">Line or offset of its first group.</param>
/// <param name="label">It and its place in words.</param>
/// <param name="start">Where its groups begin.</param>
internal sealed class DxfEntity(string kind, int place, string label, (int Offset, int Line) start)
{
    /// <summary>Its name in DXF.</summary>
    public string Kind => kind;

    /// <summary>Line or offset of its first group.</summary>
    public int Place => place;

    /// <summary>It and its place in words.</summary>
    public string Label => label;

    /// <summary>Where its groups begin.</summary>
    public (int Offset, int Line) Start => start;

    /// <summary>Its layer.</summary>
    public string Layer { get; set; } = "0";

    /// <summary>True if it is in paper space.</summary>
    public bool IsPaper { get; set; }

    /// <summary>True if it is not shown.</summary>
    public bool IsInvisible { get; set; }

    /// <summary>Its pieces; null before they are read.</summary>
    public IReadOnlyList<DrawnShape>? Shapes { get; set; }

    /// <summary>What it inserts; null before it is read, and unless it is an INSERT.</summary>
    public DxfInsert? Insert { get; set; }
}

/// <summary>A list of entities: a block, or the drawing itself.</summary>
/// <param name="name">Its name; empty for the drawing.</param>
internal sealed class DxfBlock(string name)
{
    /// <summary>Its name; empty for the drawing.</summary>
    public string Name => name;

    /// <summary>The point of the block that comes to be at the INSERT's.</summary>
    public Point2 Base { get; set; }

    /// <summary>True if its content is in another file.</summary>
    public bool IsExternal { get; set; }

    /// <summary>Its entities in the order of the file.</summary>
    public List<DxfEntity> Entities { get; } = [];

    /// <summary>The number of its entities of kinds without curves.</summary>
    public Dictionary<string, int> Others { get; } = new(StringComparer.Ordinal);

    /// <summary>True while it is being inserted.</summary>
    public bool IsOpen { get; set; }

    /// <summary>True after it was inserted once.</summary>
    public bool IsUsed { get; set; }
}

/// <summary>Copies of a block in columns and rows.</summary>
/// <param name="Block">The block.</param>
/// <param name="Outer">From the rows to the block that has the INSERT.</param>
/// <param name="Inner">From the inserted block to the first copy.</param>
/// <param name="Columns">Number of copies along X.</param>
/// <param name="Rows">Number of copies along Y.</param>
/// <param name="Step">Distances of columns and rows.</param>
internal sealed record DxfInsert(DxfBlock Block, PlaneMap Outer, PlaneMap Inner, int Columns, int Rows, Vector2 Step)
{
    /// <summary>The map of a copy, from the inserted block to the block that has the INSERT.</summary>
    public PlaneMap At(int column, int row) =>
        Outer.After(PlaneMap.Shift(new(column * Step.X, row * Step.Y)).After(Inner));
}
