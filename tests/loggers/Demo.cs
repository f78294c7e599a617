// SPDX-License-Identifier: GPL-3.0-or-later
// Logs what standard input tells, a call a line, through docs/loggers/HandholdLog.cs.
using System;
using System.Globalization;

public static class Demo
{
    public static void Main()
    {
        using (var log = new HandholdLog(Console.Out, Console.In.ReadLine()))
        {
            string line;
            while ((line = Console.In.ReadLine()) != null) Call(log, line.Split(new[] {' '}, StringSplitOptions.RemoveEmptyEntries));
        }
    }

    static void Call(HandholdLog log, string[] w)
    {
        Func<int, float> x = i => float.Parse(w[i], CultureInfo.InvariantCulture);
        if (w[0] == "frame") log.BeginFrame(double.Parse(w[1], CultureInfo.InvariantCulture));
        else if (w[0] == "joint") log.Joint(w[1], x(2), x(3), x(4), x(5));
        else if (w[0] == "hand") log.EndHand(w[1] == "right");
        else if (w[0] == "object") log.Object(w[1], x(2), x(3), x(4), x(5), x(6), x(7), x(8));
        else log.EndFrame();
    }
}
