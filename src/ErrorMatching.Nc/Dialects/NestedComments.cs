namespace ErrorMatching.Nc;

/// <summary>What a control does with a parenthesis inside a comment in parentheses.</summary>
internal enum NestedComments : byte
{
    /// <summary>Not stated: it is taken to read to the last one that fits.</summary>
    Accepted,

    /// <summary>The control refuses the block.</summary>
    Refused,

    /// <summary>The first closing parenthesis ends the comment, and a second one is refused.</summary>
    EndAtFirst,
}
