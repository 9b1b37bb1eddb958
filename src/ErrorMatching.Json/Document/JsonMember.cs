namespace ErrorMatching.Json;

/// <summary>A key of an object with its value.</summary>
/// <param name="Name">The key.</param>
/// <param name="Place">Where the key stands.</param>
/// <param name="Value">What it holds.</param>
public sealed record JsonMember(string Name, JsonPlace Place, JsonItem Value);
