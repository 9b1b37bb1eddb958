namespace ErrorMatching.Nc;

/// <summary>What a G10 block writes.</summary>
internal enum OffsetWriting : byte
{
    /// <summary>Anything: no origin and no place is known behind it.</summary>
    Unknown,

    /// <summary>The origin of a work offset in machine coordinates, under G91 too.</summary>
    Origin,

    /// <summary>The origin of a work offset in machine coordinates, under G91 by how much it moves.</summary>
    OriginByDistance,

    /// <summary>The origin of a work offset in machine coordinates; what G91 changes is not known.</summary>
    AbsoluteOrigin,

    /// <summary>The origin of a work offset so that the tool's place gets the coordinates of the block.</summary>
    TouchOff,

    /// <summary>Data of tools: a length that is active may change.</summary>
    Tool,
}
