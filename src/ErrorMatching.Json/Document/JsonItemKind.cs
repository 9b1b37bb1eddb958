namespace ErrorMatching.Json;

/// <summary>What a place of a JSON document holds.</summary>
public enum JsonItemKind
{
    /// <summary>The word null.</summary>
    Null,

    /// <summary>true or false.</summary>
    Boolean,

    /// <summary>A number.</summary>
    Number,

    /// <summary>Text in quotes.</summary>
    Text,

    /// <summary>A list in square brackets.</summary>
    List,

    /// <summary>An object in braces.</summary>
    Object,
}
