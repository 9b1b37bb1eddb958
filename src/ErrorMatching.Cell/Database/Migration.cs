namespace ErrorMatching.Cell;

/// <summary>A numbered step of the database schema.</summary>
/// <param name="Number">Its number.</param>
/// <param name="Name">Its subject.</param>
/// <param name="Sql">Its statements, with tokens such as <c>{blob}</c> where the engines' syntax differs.</param>
internal sealed record Migration(int Number, string Name, string Sql);
